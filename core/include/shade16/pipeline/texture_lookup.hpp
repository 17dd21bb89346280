// Looking a texture up: from interpolated coordinates to a texel, and to a slope of the surface.
#pragma once

#include "shade16/num/reciprocal.hpp"
#include "shade16/num/unorm.hpp"
#include "shade16/scene/needs.hpp"

namespace shade16 {

/// A place in a texture, interpolated linearly over the screen: coordinates with 13 fraction bits more than the mesh's. By
/// depth they are times q, the nearest corner's depth over the own, Q29; affinely q is 0.
struct TextureSample {
    int32_t s = 0, t = 0, q = 0;
};

/// Farthest from exact coordinates at a pixel, given the vertices on the screen, as a part of the range that the mesh's
/// coordinates have, 2^(15 - texcoord_bits): in frames of up to 256 pixels, and in proportion in larger ones.
inline constexpr int affine_coordinates_max_error_log2 = -18;
inline constexpr int perspective_coordinates_max_error_log2 = -16;

namespace detail {
/// Beyond this ratio of depths within a triangle, steps of q would be too coarse: pixels are weighed one by one.
inline constexpr int32_t least_stepped_q = int32_t{1} << 23;  // 1/64

/// Coordinates made linear on the screen; w are the corners' depths, above 0.
SHADE16_ONCE constexpr void divide_by_depth(TextureSample (&corner)[3], const int32_t (&w)[3]) {
    const int32_t nearest = max(min(w[0], min(w[1], w[2])), int32_t{1});
    for (int i = 0; i < 3; ++i) {
        const auto depth = static_cast<uint32_t>(max(w[i], nearest));
        const int shift = leading_zeros(depth);
        const uint32_t q30 = mulhi(static_cast<uint32_t>(nearest) << (shift - 1), reciprocal_of_normalized(depth << shift));
        TextureSample& c = corner[i];
        c.s = static_cast<int32_t>(shift_right_round(multiply(c.s, q30), 30));
        c.t = static_cast<int32_t>(shift_right_round(multiply(c.t, q30), 30));
        c.q = static_cast<int32_t>(max(q30 >> 1, uint32_t{1}));
    }
}

/// What divide_by_depth did, undone at a pixel.
SHADE16_INLINE constexpr TextureSample undivided(const TextureSample& at) {
    if (at.q <= 0) return at;
    const int shift = leading_zeros(static_cast<uint32_t>(at.q));  // at least 2
    const uint32_t r = reciprocal_of_normalized(static_cast<uint32_t>(at.q) << shift);
    const auto over_q = [=](int32_t c) { return static_cast<int32_t>(multiply(c, r) >> (34 - shift)); };
    return {over_q(at.s), over_q(at.t), 0};
}

/// The texels about a point, and how far the point is from the first to the second: Q15.
struct TexelCell {
    uint32_t x[2], y[2];  // y counts whole rows
    int32_t along_x = 0, along_y = 0;
};

/// `bits` are the fraction bits of s and t: at least 13, which exceeds the logarithm of any size.
template <bool Bilinear>
SHADE16_INLINE constexpr TexelCell texel_cell(const TextureSample& at, int bits, int width_log2, int height_log2) {
    const int down_x = bits - width_log2, down_y = bits - height_log2;
    const uint32_t last_x = (uint32_t{1} << width_log2) - 1, last_y = (uint32_t{1} << height_log2) - 1;
    auto s = static_cast<uint32_t>(at.s), t = static_cast<uint32_t>(at.t);  // they wrap as the texture repeats
    if constexpr (Bilinear) s -= uint32_t{1} << (down_x - 1), t -= uint32_t{1} << (down_y - 1);  // texels stand at their centres
    TexelCell cell{{(s >> down_x) & last_x, 0}, {((t >> down_y) & last_y) << width_log2, 0}};
    if constexpr (Bilinear) {
        cell.x[1] = (cell.x[0] + 1) & last_x;
        cell.y[1] = (((t >> down_y) + 1) & last_y) << width_log2;
        cell.along_x = static_cast<int32_t>(s << (32 - down_x) >> 17);
        cell.along_y = static_cast<int32_t>(t << (32 - down_y) >> 17);
    }
    return cell;
}

/// Between four values of up to 16 bits at a cell's corners, with 15 fraction bits more. Error: 1 unit.
SHADE16_INLINE constexpr int32_t mixed(const TexelCell& cell, int32_t a, int32_t b, int32_t c, int32_t d) {
    const int32_t upper = a * 32768 + (b - a) * cell.along_x, lower = c * 32768 + (d - c) * cell.along_x;
    return upper + mulhi(lower - upper, static_cast<uint32_t>(cell.along_y) << 17);
}

/// An RGB565 code as three channels of 16 bits.
SHADE16_INLINE constexpr Rgb as_rgb(uint16_t texel) {
    const auto repeated5 = [](uint32_t c) { return Unorm16::from_raw(c << 11 | c << 6 | c << 1 | c >> 4); };
    const uint32_t green = (texel >> 5) & 63;
    return {repeated5(texel >> 11), Unorm16::from_raw(green << 10 | green << 4 | green >> 2), repeated5(texel & 31)};
}
}  // namespace detail

/// How the pixels of one object look its textures up.
struct TextureLookup {
    const Texture* texture = nullptr;
    const SlopeMap* bump = nullptr;
    bool bilinear = false;
    bool by_depth = false;  // in perspective
    int bits = 27;          // fraction bits of a TextureSample
    int slope_bits = 22;    // fraction bits of a slope

    constexpr TextureLookup() = default;
    constexpr TextureLookup(const Object& o, bool perspective)
        : texture(detail::has_texture(o) ? o.material.texture.at : nullptr), bump(detail::has_bump(o) ? o.material.bump.at : nullptr),
          bilinear(o.material.filter == Filter::bilinear),
          by_depth(perspective && o.material.mapping == Mapping::perspective && (texture != nullptr || bump != nullptr)),
          bits(13 + clamp<int>(o.mesh.texcoord_bits, 0, 15)) {
        if (bump != nullptr) slope_bits = 15 + clamp<int>(bump->fraction_bits, 4, 11);
    }

    /// The coordinates at a pixel.
    template <Needs N>
    SHADE16_INLINE constexpr TextureSample place(const TextureSample& at) const {
        if constexpr (N.perspective_texture)
            if (by_depth) return detail::undivided(at);
        return at;
    }

    /// The texture's colour.
    /// Error   none but that of the coordinates, which bilinear knows to 2^-15 texel.
    /// Cost    nearest: one read; bilinear: four, and nine products.
    template <Needs N>
    SHADE16_INLINE constexpr ColorFactor color(const TextureSample& at) const {
        const Texture& map = *texture;
        const auto texel = [&](uint32_t x, uint32_t y) { return detail::as_rgb(map.texels[x + y]); };
        if constexpr (N.bilinear)
            if (bilinear) {
                const auto cell = detail::texel_cell<true>(at, bits, map.width_log2, map.height_log2);
                const Rgb a = texel(cell.x[0], cell.y[0]), b = texel(cell.x[1], cell.y[0]), c = texel(cell.x[0], cell.y[1]), d = texel(cell.x[1], cell.y[1]);
                const auto mix = [&](Unorm16 Rgb::*channel) {
                    const auto q31 = static_cast<uint32_t>(detail::mixed(cell, (a.*channel).raw, (b.*channel).raw, (c.*channel).raw, (d.*channel).raw));
                    return 2 * q31 + (q31 >> 15);  // of 65535 * 32768, widened
                };
                return {mix(&Rgb::r), mix(&Rgb::g), mix(&Rgb::b)};
            }
        const auto cell = detail::texel_cell<false>(at, bits, map.width_log2, map.height_log2);
        return texel(cell.x[0], cell.y[0]);
    }

    /// The relief's slopes along s and t, with 15 fraction bits more than the map has. Error: as `color`.
    struct Slope {
        int32_t s = 0, t = 0;
    };
    template <Needs N>
    SHADE16_INLINE constexpr Slope slope(const TextureSample& at) const {
        const SlopeMap& map = *bump;
        const auto texel = [&](uint32_t x, uint32_t y) { return Slope{int32_t{map.texels[x + y].s}, int32_t{map.texels[x + y].t}}; };
        if constexpr (N.bilinear)
            if (bilinear) {
                const auto cell = detail::texel_cell<true>(at, bits, map.width_log2, map.height_log2);
                const Slope a = texel(cell.x[0], cell.y[0]), b = texel(cell.x[1], cell.y[0]), c = texel(cell.x[0], cell.y[1]), d = texel(cell.x[1], cell.y[1]);
                return {detail::mixed(cell, a.s, b.s, c.s, d.s), detail::mixed(cell, a.t, b.t, c.t, d.t)};
            }
        const auto cell = detail::texel_cell<false>(at, bits, map.width_log2, map.height_log2);
        const Slope one = texel(cell.x[0], cell.y[0]);
        return {one.s * 32768, one.t * 32768};
    }
};

}  // namespace shade16
