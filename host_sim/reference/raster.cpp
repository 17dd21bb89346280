#include "host_sim/reference/raster.hpp"

#include <algorithm>
#include <cmath>

namespace shade16::reference {

namespace {
/// Twice the area of (a, b, p); positive when they run clockwise on a screen whose y points down.
double edge(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Whether a point exactly on the edge from a to b of a clockwise triangle belongs to it: top and left edges do.
bool is_top_left(const glm::dvec2& a, const glm::dvec2& b) { return (a.y == b.y && b.x > a.x) || b.y < a.y; }

bool inside(double weight, const glm::dvec2& a, const glm::dvec2& b) { return weight > 0 || (weight == 0 && is_top_left(a, b)); }
}  // namespace

Picture::Picture(Viewport viewport, const glm::dvec3& background)
    : width(viewport.width), height(viewport.height), color(index(0, height), background), depth(index(0, height), 2.0), covered(index(0, height), false) {}

glm::dvec3 barycentric(const std::array<glm::dvec2, 3>& c, const glm::dvec2& p) {
    const double area = edge(c[0], c[1], c[2]);
    return {edge(c[1], c[2], p) / area, edge(c[2], c[0], p) / area, edge(c[0], c[1], p) / area};
}

void raster(Picture& picture, const std::array<Vertex, 3>& corner, const Shade& shade) {
    // Counter-clockwise triangles are walked as their clockwise mirror, so that the fill rule reads as usual.
    const Vertex &a = corner[0], &b = corner[2], &c = corner[1];
    const double area = edge(a.position, b.position, c.position);
    if (!(area > 0)) return;
    const auto bounds = [&](auto coordinate, int limit) {
        const auto [low, high] = std::minmax({coordinate(a), coordinate(b), coordinate(c)});
        return std::pair{static_cast<int>(std::clamp(std::floor(low), 0.0, double(limit))), static_cast<int>(std::clamp(std::ceil(high) + 1, 0.0, double(limit)))};
    };
    const auto [left, right] = bounds([](const Vertex& v) { return v.position.x; }, picture.width);
    const auto [top, bottom] = bounds([](const Vertex& v) { return v.position.y; }, picture.height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const glm::dvec2 p(x + 0.5, y + 0.5);
            const double wa = edge(b.position, c.position, p), wb = edge(c.position, a.position, p), wc = edge(a.position, b.position, p);
            if (!inside(wa, b.position, c.position) || !inside(wb, c.position, a.position) || !inside(wc, a.position, b.position)) continue;
            const double depth = (wa * a.depth + wb * b.depth + wc * c.depth) / area;
            const std::size_t i = picture.index(x, y);
            if (depth >= picture.depth[i]) continue;
            picture.depth[i] = depth;
            const glm::dvec3 interpolated = (wa * a.color + wb * b.color + wc * c.color) / area;
            picture.color[i] = shade ? shade(interpolated, p) : interpolated;
            picture.covered[i] = true;
        }
}

}  // namespace shade16::reference
