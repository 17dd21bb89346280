// Colour stepping, policy `packed`: three channels in one word, one addition a pixel. Signed steps work because the
// packed sum is linear modulo 2^32; half a code of bias rounds, and keeps a field from borrowing of its neighbour.
#pragma once

#include "shade16/pipeline/depth.hpp"

namespace shade16 {

/// Farthest from exact interpolation before rounding, in codes of the target: 28 pixels of 1/64, and a floor of 1/32.
inline constexpr uint32_t packed_stepping_max_error_per_1024_code = 512;

/// Colours as Q16 codes.
struct CodePlane {
    int32_t r = 0, g = 0, b = 0;
};

namespace detail {
/// Numbers of 1/32 code as fields: [green 6.5 | red 5.5, 0 | blue 5.5]. Red and blue alike, so that grey stays grey.
SHADE16_INLINE constexpr uint32_t join_fields(int32_t r, int32_t g, int32_t b) {
    return (static_cast<uint32_t>(g) << 21) + (static_cast<uint32_t>(r) << 11) + static_cast<uint32_t>(b);
}
SHADE16_INLINE constexpr uint32_t pack_fields(const CodePlane& c) { return join_fields(c.r >> 11, c.g >> 11, c.b >> 11); }
SHADE16_INLINE constexpr uint32_t pack_steps(const CodePlane& c) { return pack_fields({c.r + 1024, c.g + 1024, c.b + 1024}); }

/// What 16 rounded steps lack of the true one.
SHADE16_INLINE constexpr uint32_t correction_after_16(const CodePlane& c) {
    return pack_steps({c.r * 16, c.g * 16, c.b * 16}) - 16 * pack_steps(c);
}

template <PrecisionTier Tier>
constexpr CodePlane corner_codes(const ScreenVertex<Tier>& v) {
    constexpr int down = ScreenVertex<Tier>::channel_bits - 15;
    const auto code = [](uint32_t c, int max) { return static_cast<int32_t>(c >> down) * max * 2; };
    return {code(v.r, 31), code(v.g, 63), code(v.b, 31)};
}
}  // namespace detail

/// Colour over one triangle, in Q16 codes: at the reference pixel of the current row, and its slopes.
struct PackedPlanes {
    CodePlane value{}, step_x{}, step_y{};

    template <PrecisionTier Tier>
    SHADE16_INLINE constexpr PackedPlanes(const TriangleSetup<Tier>& t, RasterPoint from_corner) {
        const CodePlane c0 = detail::corner_codes(*t.corner[0]);
        value = {c0.r + 0x8000, c0.g + 0x8000, c0.b + 0x8000};
        const InverseArea five = t.inverse.times_codes(5), six = t.inverse.times_codes(6);
        set_channel(t, five, 10, &ScreenVertex<Tier>::r, value.r, step_x.r, step_y.r, from_corner);
        set_channel(t, six, 11, &ScreenVertex<Tier>::g, value.g, step_x.g, step_y.g, from_corner);
        set_channel(t, five, 10, &ScreenVertex<Tier>::b, value.b, step_x.b, step_y.b, from_corner);
    }

private:
    template <PrecisionTier Tier>
    SHADE16_INLINE static constexpr void set_channel(const TriangleSetup<Tier>& t, const InverseArea& inverse, int exponent,
                                                     typename ScreenVertex<Tier>::Channel ScreenVertex<Tier>::*channel,
                                                     int32_t& value, int32_t& dx, int32_t& dy, RasterPoint from_corner) {
        constexpr int down = ScreenVertex<Tier>::channel_bits - 15;
        const auto at = [&](int i) { return static_cast<int32_t>(t.corner[i]->*channel >> down); };
        const int32_t c0 = at(0), d1 = at(1) - c0, d2 = at(2) - c0;
        if (t.is_compact()) {
            // |slope| < 2^(16 + reach_bits): lifted to 30 bits. No sliver, so area > 2^(reach_bits + 1) and right >= 2.
            const int lift = 14 - t.reach_bits, right = 30 + lift - exponent - inverse.shift;
            dx = mulhi(shift_left(t.slope_x(d1, d2), lift), inverse.mantissa) >> right;
            dy = mulhi(shift_left(t.slope_y(d1, d2), lift), inverse.mantissa) >> right;
        } else {
            dx = inverse.times(t.long_slope_x(d1, d2), exponent);
            dy = inverse.times(t.long_slope_y(d1, d2), exponent);
        }
        value += (dx >> 4) * from_corner.x + (dy >> 4) * from_corner.y;
    }
};

/// For any triangle: three exact accumulators a row, the packed word within it, corrected every 16 pixels and made anew
/// every 128.
template <PackedFormat Format, bool Depth>
class PackedPainter {
public:
    SHADE16_INLINE constexpr PackedPainter(const PackedPlanes& c, const DepthPlane& depth)
        : color_(c), depth_(depth), step_(detail::pack_steps(c.step_x)), correction_(detail::correction_after_16(c.step_x)) {}

    constexpr void skip_rows(int32_t rows) {
        color_.value = moved(color_.value, color_.step_y, rows);
        depth_.skip_rows(rows);
    }
    SHADE16_INLINE constexpr void next_row() {
        color_.value = moved(color_.value, color_.step_y, 1);
        if constexpr (Depth) depth_.next_row();
    }
    SHADE16_INLINE constexpr void span(typename Format::Pixel* pixel, uint16_t* stored, int32_t column, int32_t count) const {
        uint32_t z = Depth ? depth_.at(column) : 0;
        CodePlane c = moved(color_.value, color_.step_x, column);
        for (; count > 0; c = moved(c, color_.step_x, 128)) {
            uint32_t word = detail::pack_fields(c);
            int32_t stretch = min<int32_t>(count, 128);
            count -= stretch;
            for (; stretch >= 16; stretch -= 16) {
                four(pixel, stored, 0, word, z);
                four(pixel, stored, 4, word, z);
                four(pixel, stored, 8, word, z);
                four(pixel, stored, 12, word, z);
                word += correction_;
                pixel += 16;
                if constexpr (Depth) stored += 16;
            }
            for (; stretch > 0; --stretch) {
                one(pixel, stored, 0, word, z);
                ++pixel;
                if constexpr (Depth) ++stored;
            }
        }
    }

private:
    SHADE16_INLINE static constexpr CodePlane moved(const CodePlane& c, const CodePlane& step, int32_t n) {
        // Modulo 2^32: steps may be steep, values at covered pixels are not.
        const auto sum = [n](int32_t v, int32_t s) { return static_cast<int32_t>(static_cast<uint32_t>(v) + static_cast<uint32_t>(s) * static_cast<uint32_t>(n)); };
        return {sum(c.r, step.r), sum(c.g, step.g), sum(c.b, step.b)};
    }
    SHADE16_INLINE constexpr void one(typename Format::Pixel* pixel, uint16_t* stored, int32_t i, uint32_t& word, uint32_t& z) const {
        if (nearer<Depth>(stored + i, z)) pixel[i] = Format::from_word(word);
        word += step_;
        if constexpr (Depth) z += static_cast<uint32_t>(depth_.step_x);
    }
    SHADE16_INLINE constexpr void four(typename Format::Pixel* pixel, uint16_t* stored, int32_t i, uint32_t& word, uint32_t& z) const {
        one(pixel, stored, i, word, z);
        one(pixel, stored, i + 1, word, z);
        one(pixel, stored, i + 2, word, z);
        one(pixel, stored, i + 3, word, z);
    }

    PackedPlanes color_;
    DepthPlane depth_;
    uint32_t step_, correction_;
};

}  // namespace shade16
