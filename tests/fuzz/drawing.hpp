// Drawing: a frame of a scene, and the target that it is for.
#pragma once

#include "shade16/shade16.hpp"

namespace shade16::fuzz {

/// A tier with a format. A pipeline of all terms takes a compiler long, so that not every tier draws every format; but each of them is
/// drawn, and packed and exact stepping, in three channels and in one.
struct Target {
    const char *tier, *format;
};
inline constexpr Target targets[] = {
    {"lowp", "rgb565"},         {"lowp", "rgb888"},            {"lowp", "gray8"},        {"lowp", "mono1, dithered 8x8"},
    {"mediump", "rgb565"},      {"mediump", "rgb565_swapped"}, {"mediump", "mono1"},     {"mediump", "gray4"},
    {"highp", "rgb888"},        {"highp", "rgb565, dithered 4x4"}, {"highp", "gray8"},   {"highp", "gray4, dithered 8x8"},
};
inline constexpr uint32_t target_count = sizeof(targets) / sizeof(targets[0]);
inline constexpr uint32_t mediump_rgb565 = 4;

struct Drawing {
    const Scene* scene = nullptr;
    const Frame* frame = nullptr;
    uint32_t target = mediump_rgb565;
    Viewport viewport{};
    int32_t band_rows = 1;
};

/// Draws the frame whole and in bands. Stops the program with a sentence if a band writes beside its memory or the two
/// pictures differ. Returns whether anything shows.
bool check_drawing(const Drawing& drawing);

/// With the pipeline of the target; one a file, so that they compile side by side.
template <PrecisionTier Tier, Channels Colors>
bool check_drawing_of(const Drawing& drawing);

}  // namespace shade16::fuzz
