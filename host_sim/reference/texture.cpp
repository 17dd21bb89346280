#include "host_sim/reference/texture.hpp"

#include <cmath>

namespace shade16::reference {

namespace {
/// The channel's bits repeated to 16, as the engine reads a texel.
glm::dvec3 color_of(uint16_t texel) {
    const auto channel = [](unsigned code, int bits) {
        unsigned repeated = 0;
        for (int at = 16 - bits; at > -bits; at -= bits) repeated |= at >= 0 ? code << at : code >> -at;
        return repeated / 65535.0;
    };
    return {channel(texel >> 11, 5), channel((texel >> 5) & 63u, 6), channel(texel & 31u, 5)};
}

/// `texel(x, y)` at (s, t) of a picture of so many texels.
template <class Texel>
auto sampled(int width_log2, int height_log2, Filter filter, const glm::dvec2& at, Texel texel) {
    const int width = 1 << width_log2, height = 1 << height_log2;
    const auto wrapped = [](double i, int size) { return static_cast<uint32_t>(static_cast<int64_t>(i) & (size - 1)); };
    if (filter == Filter::nearest) return texel(wrapped(std::floor(at.x * width), width), wrapped(std::floor(at.y * height), height));
    const glm::dvec2 p = at * glm::dvec2(width, height) - 0.5, cell = glm::floor(p), f = p - cell;
    const auto corner = [&](int x, int y) { return texel(wrapped(cell.x + x, width), wrapped(cell.y + y, height)); };
    return glm::mix(glm::mix(corner(0, 0), corner(1, 0), f.x), glm::mix(corner(0, 1), corner(1, 1), f.x), f.y);
}
}  // namespace

glm::dvec3 texture_color(const Texture& texture, Filter filter, const glm::dvec2& at) {
    return sampled(texture.width_log2, texture.height_log2, filter, at,
                   [&](uint32_t x, uint32_t y) { return color_of(texture.texels[(y << texture.width_log2) + x]); });
}

glm::dvec2 relief_slope(const SlopeMap& map, Filter filter, const glm::dvec2& at) {
    return sampled(map.width_log2, map.height_log2, filter, at, [&](uint32_t x, uint32_t y) {
        const Slope8 slope = map.texels[(y << map.width_log2) + x];
        return glm::dvec2(slope.s, slope.t) * std::ldexp(1.0, -map.fraction_bits);
    });
}

glm::dvec2 texture_coordinates(const std::array<glm::dvec2, 3>& corner, const FacePoint& at, bool by_depth) {
    const glm::dvec3& w = by_depth ? at.weights_in_space : at.weights;
    return (w.x * corner[0] + w.y * corner[1] + w.z * corner[2]) / (w.x + w.y + w.z);
}

Tangents face_tangents(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& at) {
    const glm::dvec3 b = p[1] - p[0], c = p[2] - p[0];
    const glm::dvec2 to_b = at[1] - at[0], to_c = at[2] - at[0];
    const double area = to_b.x * to_c.y - to_c.x * to_b.y;
    if (area == 0) return {};
    return {glm::normalize((b * to_c.y - c * to_b.y) / area), glm::normalize((c * to_b.x - b * to_c.x) / area)};
}

}  // namespace shade16::reference
