#include "host_sim/gallery/heat_map.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "host_sim/gallery/font.hpp"

namespace shade16::host {

namespace {

constexpr int steps = 16;  // few enough that a map is a small file
constexpr Ink24 covered_by_one_ink{64, 128, 255};

/// Red, then green, then blue: black, red, yellow, white.
Ink24 heat(int step) {
    const auto ramp = [&](int first) { return static_cast<uint8_t>(std::clamp((step - first) * 255 / 5, 0, 255)); };
    return {ramp(0), ramp(5), ramp(10)};
}

int step_of(double levels) { return std::min(static_cast<int>(levels / heat_scale_levels * (steps - 1)), steps - 1); }

}  // namespace

Image heat_map(const ReferenceDifference& d) {
    Canvas canvas(d.width, d.height);
    for (int y = 0; y < d.height; ++y)
        for (int x = 0; x < d.width; ++x) {
            const auto i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(d.width) + static_cast<std::size_t>(x);
            canvas.dot(x, y, d.covered_by_one[i] ? covered_by_one_ink : heat(step_of(d.levels[i])));
        }
    return canvas.image();
}

Image heat_scale() {
    constexpr int box = 6;
    const std::string end = fmt::format("{:.2f} levels", heat_scale_levels), blue = "one engine alone";
    int x = 0;
    Canvas canvas(glyph_pitch_px * static_cast<int>(end.size() + blue.size() + 4) + box * (steps + 2), glyph_rows_px);
    canvas.write("0", x, 0);
    x += 2 * glyph_pitch_px - 2;
    for (int step = 0; step < steps; ++step, x += box) canvas.fill(x, 0, box, glyph_height_px, heat(step));
    canvas.write(end, x + 4, 0);
    x += 4 + glyph_pitch_px * static_cast<int>(end.size() + 1);
    canvas.fill(x, 0, box, glyph_height_px, covered_by_one_ink);
    canvas.write(blue, x + box + 4, 0);
    return canvas.image();
}

}  // namespace shade16::host
