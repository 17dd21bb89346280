// Drawing a band, for one format of pixels. Each format is a file of its own, so that a program links those alone that it calls.
#pragma once

#include "check.hpp"
#include "renderer.hpp"

namespace shade16::c {

inline shade16_status check_band(const shade16_renderer* r, const void* pixels, const uint16_t* depth, int32_t first_row, int32_t rows) {
    if (r == nullptr || pixels == nullptr) return SHADE16_NULL_ARGUMENT;
    if (!r->is_begun) return SHADE16_NOT_BEGUN;
    const int32_t height = r->viewport.height;
    if (first_row < 0 || first_row >= height || rows < 1 || rows > height - first_row) return SHADE16_BAND_OUTSIDE;
    if (chosen_terms.depth && depth == nullptr) return SHADE16_NO_DEPTH;
    return SHADE16_OK;
}

template <PixelFormat Format>
using PixelOf = typename Format::Pixel;

template <PixelFormat Format>
shade16_status draw(shade16_renderer* r, typename Format::Pixel* pixels, uint16_t* depth, int32_t first_row, int32_t rows) {
    if (const shade16_status status = check_band(r, pixels, depth, first_row, rows); status != SHADE16_OK) return status;
    if ((sizeof(*pixels) > 1 && is_misaligned(pixels)) || is_misaligned(depth)) return SHADE16_ARRAY_MISALIGNED;
    r->pipeline.draw(Band<Format>{pixels, chosen_terms.depth ? depth : nullptr, r->viewport.width, first_row, rows});
    return SHADE16_OK;
}

}  // namespace shade16::c

/// Defines shade16_draw_<name>.
#define SHADE16_C_DRAW(name, ...)                                                                                                              \
    extern "C" shade16_status shade16_draw_##name(shade16_renderer* renderer, shade16::c::PixelOf<__VA_ARGS__>* pixels, uint16_t* depth, \
                                                  int32_t first_row, int32_t rows) {                                                           \
        return shade16::c::draw<__VA_ARGS__>(renderer, pixels, depth, first_row, rows);                                                        \
    }
