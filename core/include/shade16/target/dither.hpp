// Ordered dithering: a threshold that depends on a pixel's place in the frame alone stands in for the half code that
// rounds, so that a share of the pixels shows the next code and their mean the colour between.
#pragma once

#include "shade16/target/pixel.hpp"

namespace shade16 {

/// A square of thresholds that tiles the frame. thresholds[y][x] are 0 to side^2 - 1, each once; a matrix of side 4 is here
/// four times, so that all of them are read alike.
struct BayerMatrix {
    int side = 0;
    uint8_t thresholds[8][8]{};
    friend constexpr bool operator==(const BayerMatrix&, const BayerMatrix&) = default;
};

namespace detail {
/// Source  B. E. Bayer, An optimum method for two-level rendition of continuous-tone pictures, 1973.
consteval BayerMatrix make_bayer(int side) {
    BayerMatrix m{side};
    for (unsigned y = 0; y < 8; ++y)
        for (unsigned x = 0; x < 8; ++x)
            for (unsigned bit = 1; static_cast<int>(bit) < side; bit *= 2) {
                const unsigned pair = ((x ^ y) & bit ? 2u : 0u) + (y & bit ? 1u : 0u);
                m.thresholds[y][x] = static_cast<uint8_t>(m.thresholds[y][x] * 4 + pair);
            }
    return m;
}
}  // namespace detail

SHADE16_TABLE BayerMatrix bayer4 = detail::make_bayer(4), bayer8 = detail::make_bayer(8);

/// A format whose channels are dithered. Colours are stepped by the policy `exact` whatever the tier.
/// Error   less than one code from the exact colour, and the stepping bound; the mean of a tile is within half a threshold's
///         step, 1/32 or 1/128 code. A colour within that of a code is that code everywhere: black, white and flat colours
///         have no noise.
template <PixelFormat Base, const BayerMatrix& Matrix>
struct Dithered;

template <ColorFormat Base, const BayerMatrix& Matrix>
struct Dithered<Base, Matrix> {
    using Undithered = Base;
    using Pixel = typename Base::Pixel;
    static constexpr const BayerMatrix& matrix = Matrix;
    static constexpr int red_bits = Base::red_bits, green_bits = Base::green_bits, blue_bits = Base::blue_bits;
    static constexpr Pixel pack(uint32_t r, uint32_t g, uint32_t b) { return Base::pack(r, g, b); }
};

template <GrayFormat Base, const BayerMatrix& Matrix>
struct Dithered<Base, Matrix> {
    using Undithered = Base;
    using Pixel = typename Base::Pixel;
    static constexpr const BayerMatrix& matrix = Matrix;
    static constexpr int luma_bits = Base::luma_bits, pixels_a_byte_log2 = shade16::pixels_a_byte_log2<Base>;
    static constexpr Pixel pack(uint32_t luma) { return Base::pack(luma); }
};

template <class F>
concept DitheredFormat = PixelFormat<F> && requires { F::matrix.side; };

namespace detail {
template <DitheredFormat Format>
inline constexpr int threshold_bits = Format::matrix.side == 4 ? 4 : 6;

/// What is added to a colour in Q24 codes before its fraction is dropped: half a code; or, where the pixel's own threshold is
/// to follow, half of a threshold's step.
template <PixelFormat Format>
constexpr uint32_t q24_bias() {
    if constexpr (DitheredFormat<Format>) return uint32_t{1} << (23 - threshold_bits<Format>);
    else return uint32_t{1} << 23;
}
}  // namespace detail

}  // namespace shade16
