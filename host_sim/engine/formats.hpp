// Tiers and formats by name, for programs that learn them at run time.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/error.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

/// Calls `use(tier{})` with the tier of that name.
template <class Use>
decltype(auto) with_tier(std::string_view name, Use&& use) {
    if (name == lowp::name) return use(lowp{});
    if (name == mediump::name) return use(mediump{});
    if (name == highp::name) return use(highp{});
    throw input_error("--tier {}: expected lowp, mediump or highp.", name);
}

/// Calls `use(format{})` with the format of that name.
template <class Use>
decltype(auto) with_format(std::string_view name, Use&& use) {
    if (name == Rgb565::name) return use(Rgb565{});
    if (name == Rgb565Swapped::name) return use(Rgb565Swapped{});
    if (name == Rgb888::name) return use(Rgb888{});
    throw input_error("--format {}: expected rgb565, rgb565_swapped or rgb888.", name);
}

/// An 8-bit code of a pixel's channel, rounded.
constexpr uint8_t widened(uint32_t code, int bits) {
    const uint32_t max_code = (1u << bits) - 1;
    return static_cast<uint8_t>((code * 255 + max_code / 2) / max_code);
}
constexpr Rgb888::Pixel as_rgb888(uint16_t p) { return {widened(p >> 11, 5), widened((p >> 5) & 63, 6), widened(p & 31, 5)}; }

template <PixelFormat Format>
constexpr Rgb888::Pixel as_rgb888(const typename Format::Pixel& pixel) {
    if constexpr (requires { pixel.r; }) return pixel;
    else if constexpr (requires { Format::swapped(pixel); }) return as_rgb888(Format::swapped(pixel));
    else return as_rgb888(pixel);
}

}  // namespace shade16::host
