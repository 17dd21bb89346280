// Convexity of a surface that need not be closed. Exact: 64-bit integers.
#include <algorithm>
#include <array>

#include "host_sim/scene_file/loaded_mesh.hpp"

namespace shade16::host {

namespace {

using Point = std::array<int64_t, 3>;
using Face = std::array<Point, 3>;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// Differences have 17 bits: 35 bits here, and 54 in the dot product with another difference.
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int64_t dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point normal_of(const Face& f) { return cross(f[1] - f[0], f[2] - f[0]); }

int64_t height(const Face& face, const Point& p) { return dot(normal_of(face), p - face[0]); }

/// Whether an edge of `a` has all of `a` on one side and all of `b` on the other, in their common plane. In the plane's
/// shadow along its steepest axis, so that products stay small.
bool edge_separates(const Face& a, const Face& b, std::size_t u, std::size_t v) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Point &from = a[i], &to = a[(i + 1) % 3];
        const auto side = [&](const Point& p) {
            return (to[u] - from[u]) * (p[v] - from[v]) - (to[v] - from[v]) * (p[u] - from[u]);
        };
        const int64_t own = side(a[(i + 2) % 3]);
        if (std::all_of(b.begin(), b.end(), [&](const Point& p) { return own > 0 ? side(p) <= 0 : side(p) >= 0; }))
            return true;
    }
    return false;
}

bool overlap(const Face& a, const Face& b) {
    const Point n = normal_of(a);
    const auto size = [&](std::size_t i) { return n[i] < 0 ? -n[i] : n[i]; };
    const std::size_t axis = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return !edge_separates(a, b, u, v) && !edge_separates(b, a, u, v);
}

}  // namespace

bool hides_nothing_of_itself(const Mesh& mesh) {
    std::vector<Face> faces;
    const auto point = [&](uint16_t i) { return Point{mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z}; };
    for (const Triangle& t : mesh.triangles) faces.push_back({point(t.a), point(t.b), point(t.c)});
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = 0; j < faces.size(); ++j) {
            if (i == j) continue;
            const auto above = [&](const Point& p) { return height(faces[i], p) > 0; };
            const auto level = [&](const Point& p) { return height(faces[i], p) == 0; };
            if (std::any_of(faces[j].begin(), faces[j].end(), above)) return false;
            if (std::all_of(faces[j].begin(), faces[j].end(), level) && overlap(faces[i], faces[j])) return false;
        }
    return true;
}

}  // namespace shade16::host
