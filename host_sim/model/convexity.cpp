#include "host_sim/model/convexity.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace shade16::host {

namespace {

using Point = std::array<int64_t, 3>;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// Differences have 17 bits: 35 bits here, and 54 in the dot product with another difference.
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int64_t dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

using Face = std::array<Point, 3>;

std::vector<Face> faces_of(std::span<const Position16> positions, std::span<const Triangle> triangles) {
    const auto point = [&](uint16_t i) { return Point{positions[i].x, positions[i].y, positions[i].z}; };
    std::vector<Face> faces;
    for (const Triangle& t : triangles) faces.push_back({point(t.a), point(t.b), point(t.c)});
    return faces;
}

bool is_closed(const std::vector<Face>& faces) {
    std::set<std::pair<Point, Point>> edges;
    for (const Face& face : faces)
        for (std::size_t i = 0; i < 3; ++i)
            if (!edges.emplace(face[i], face[(i + 1) % 3]).second) return false;
    return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return edges.contains({edge.second, edge.first});
    });
}

bool all_behind(const std::set<Point>& points, const Face& face) {
    const Point normal = cross(face[1] - face[0], face[2] - face[0]);
    return std::all_of(points.begin(), points.end(), [&](const Point& p) { return dot(normal, p - face[0]) <= 0; });
}

}  // namespace

bool is_convex(std::span<const Position16> positions, std::span<const Triangle> triangles) {
    const std::vector<Face> faces = faces_of(positions, triangles);
    if (faces.empty() || !is_closed(faces)) return false;
    std::set<Point> points;
    for (const Face& face : faces) points.insert(face.begin(), face.end());
    return std::all_of(faces.begin(), faces.end(), [&](const Face& face) { return all_behind(points, face); });
}

}  // namespace shade16::host
