// Formats that keep what the real ones round away: the same arithmetic to the last step, so that a comparison can tell
// the error of shading and stepping from the display's own rounding.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include "host_sim/engine/codes.hpp"
#include "shade16/target/pixel.hpp"

namespace shade16::host {

/// What Rgb565 makes a pixel of, before it does.
struct UnroundedRgb565 {
    struct Pixel {
        bool packed = false;           // what the pixel was made of: a word, or three Q24 codes
        uint32_t word = 0;
        uint32_t r = 0, g = 0, b = 0;
    };
    static constexpr int red_bits = 5, green_bits = 6, blue_bits = 5;
    static constexpr Pixel pack(uint32_t, uint32_t, uint32_t) { return {}; }
    static constexpr Pixel from_word(uint32_t word) { return {true, word, 0, 0, 0}; }
    static constexpr Pixel from_q24(uint32_t r, uint32_t g, uint32_t b) { return {false, 0, r, g, b}; }
};

/// The luma in [0, 1] in all channels.
template <GrayFormat Format>
glm::dvec3 value_of(const typename Format::Pixel& p) {
    return glm::dvec3((p.luma * 0x1p-24 - 0.5) / ((1 << Format::luma_bits) - 1));
}

/// The colour in [0, 1] that the pixel stands for, without the half code that rounds. Fields: [green 6.5 | red 5.6 | blue 5.5].
inline glm::dvec3 value(const UnroundedRgb565::Pixel& p) {
    if (!p.packed) return (glm::dvec3(p.r, p.g, p.b) * 0x1p-24 - 0.5) / glm::dvec3(31, 63, 31);
    const double green = (p.word >> 21) / 32.0, red = ((p.word >> 10) & 0x7FF) / 64.0, blue = (p.word & 0x3FF) / 32.0;
    return (glm::dvec3(red, green, blue) - 0.5) / glm::dvec3(31, 63, 31);
}
template <ColorFormat Format>
glm::dvec3 value_of(const typename Format::Pixel& p) {
    return value(p);
}

}  // namespace shade16::host
