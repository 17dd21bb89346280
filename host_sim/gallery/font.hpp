// A font of 5x7 pixels for captions: printable ASCII, no file, legible at one pixel a pixel.
#pragma once

#include <array>
#include <cstdint>

namespace shade16::host {

inline constexpr int glyph_width_px = 5, glyph_height_px = 7, glyph_pitch_px = 6;
inline constexpr int glyph_rows_px = glyph_height_px + 1;  // with what hangs below the line

/// Five columns from the left; bit 0 is the top row, bit 7 is below the line. What is not printable shows as a question
/// mark.
const std::array<uint8_t, glyph_width_px>& glyph_of(char character);

}  // namespace shade16::host
