// Tiers, pixel formats and dithering by name, for programs that learn them at run time.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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

/// The names of all formats, and of what dithers them.
inline const std::vector<std::string> format_names{Rgb565::name, Rgb565Swapped::name, Rgb888::name,
                                                   Gray8::name,  Gray4::name,         Mono1::name};
inline const std::vector<std::string> dither_names{"none", "4x4", "8x8"};

/// What a display takes: a format, and how colours between its codes are shown.
struct TargetFormat {
    std::string format = Rgb565::name, dither = "none";
};

inline bool is_gray(std::string_view format) {
    return format == Gray8::name || format == Gray4::name || format == Mono1::name;
}

/// Calls `use(format{})` with the format of that name, without dithering.
template <class Use>
decltype(auto) with_format(std::string_view name, Use&& use) {
    if (name == Rgb565::name) return use(Rgb565{});
    if (name == Rgb565Swapped::name) return use(Rgb565Swapped{});
    if (name == Rgb888::name) return use(Rgb888{});
    if (name == Gray8::name) return use(Gray8{});
    if (name == Gray4::name) return use(Gray4{});
    if (name == Mono1::name) return use(Mono1{});
    throw input_error("--format {}: expected rgb565, rgb565_swapped, rgb888, gray8, gray4 or mono1.", name);
}

/// Calls `use(format{})` with the format as it is dithered.
template <class Use>
decltype(auto) with_target(const TargetFormat& target, Use&& use) {
    return with_format(target.format, [&]<class Format>(Format format) -> decltype(auto) {
        if (target.dither == dither_names[0]) return use(format);
        if constexpr (std::is_same_v<Format, Rgb888>) {
            throw input_error(
                "--dither {}: rgb888 shows every level there is; expected none, or a --format of fewer codes.",
                target.dither);
        } else {
            if (target.dither == dither_names[1]) return use(Dithered<Format, bayer4>{});
            if (target.dither == dither_names[2]) return use(Dithered<Format, bayer8>{});
            throw input_error("--dither {}: expected none, 4x4 or 8x8.", target.dither);
        }
    });
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
    else if constexpr (DitheredFormat<Format>) return as_rgb888<typename Format::Undithered>(pixel);
    else return as_rgb888(pixel);
}

/// The pixel of a row of memory.
template <PixelFormat Format>
constexpr Rgb888::Pixel rgb888_at(const typename Format::Pixel* row, int32_t x) {
    if constexpr (GrayFormat<Format>) {
        const uint8_t gray = widened(luma_code<Format>(row, x), Format::luma_bits);
        return {gray, gray, gray};
    } else {
        return as_rgb888<Format>(row[x]);
    }
}

}  // namespace shade16::host
