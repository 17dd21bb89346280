#include "host_sim/reference/normals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shade16::reference {

namespace {
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

/// The formula divides by sin(a): straight where a is nothing. (Opposite normals have no arc; meshes with such corners are
/// not compared.)
glm::dvec3 slerp(const glm::dvec3& n0, const glm::dvec3& n1, double t) {
    const double a = std::atan2(glm::length(glm::cross(n0, n1)), glm::dot(n0, n1));
    if (std::sin(a) < 1e-9) return unit(glm::mix(n0, n1, t));
    return (std::sin((1 - t) * a) * n0 + std::sin(t * a) * n1) / std::sin(a);
}

struct Crossing {
    double x = 0;
    glm::dvec3 normal{};
};
}  // namespace

glm::dvec3 linear_normal(const std::array<glm::dvec3, 3>& n, const glm::dvec3& w) { return unit(w.x * n[0] + w.y * n[1] + w.z * n[2]); }

glm::dvec3 spherical_normal(const std::array<glm::dvec3, 3>& normals, const FacePoint& at) {
    const std::array<glm::dvec2, 3>& p = at.corner_px;
    const glm::dvec2 here = at.weights.x * p[0] + at.weights.y * p[1] + at.weights.z * p[2];
    std::vector<Crossing> crossings;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (p[k].y == p[next].y) continue;
        const double t = (here.y - p[k].y) / (p[next].y - p[k].y);
        if (t < -1e-9 || t > 1 + 1e-9) continue;
        crossings.push_back({p[k].x + t * (p[next].x - p[k].x), slerp(unit(normals[k]), unit(normals[next]), std::clamp(t, 0.0, 1.0))});
    }
    if (crossings.empty()) return linear_normal(normals, at.weights);
    const auto [left, right] = std::minmax_element(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    const double width = right->x - left->x;
    return slerp(left->normal, right->normal, width > 0 ? std::clamp((here.x - left->x) / width, 0.0, 1.0) : 0.5);
}

glm::dvec3 mapped_normal(const std::array<glm::dvec3, 3>& normals, const glm::dvec3& weights, const glm::dmat3& world_to_view) {
    constexpr double reach = 0.8;
    glm::dvec2 place(0);
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 n = world_to_view * normals[static_cast<std::size_t>(k)];
        glm::dvec2 p = glm::dvec2(n) / std::sqrt(std::max(2 * (1 + n.z), 1e-12));
        if (glm::length(p) > reach) p *= reach / glm::length(p);
        place += weights[k] * p;
    }
    const double squared = glm::dot(place, place);
    return glm::transpose(world_to_view) * glm::dvec3(2.0 * std::sqrt(1 - squared) * place, 1 - 2 * squared);
}

}  // namespace shade16::reference
