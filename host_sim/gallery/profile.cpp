#include "host_sim/gallery/profile.hpp"

#include <algorithm>

#include "host_sim/gallery/canvas.hpp"

namespace shade16::host {

Image profile_of_middle_row(const Image& picture, int height) {
    constexpr Ink24 ground{6, 10, 14}, grid{40, 50, 60}, line{255, 208, 64};
    Canvas canvas(picture.width, height, ground);
    for (int quarter = 0; quarter <= 4; ++quarter) canvas.fill(0, quarter * (height - 1) / 4, picture.width, 1, grid);
    const uint8_t* const row = picture.rgb.data() + 3 * static_cast<std::ptrdiff_t>(picture.height / 2) * picture.width;
    int before = 0;
    for (int x = 0; x < picture.width; ++x) {
        const double luma = 0.299 * row[3 * x] + 0.587 * row[3 * x + 1] + 0.114 * row[3 * x + 2];
        const int y = static_cast<int>((255 - luma) / 255 * (height - 1) + 0.5);
        const int top = x == 0 ? y : std::min(y, before), bottom = x == 0 ? y : std::max(y, before);
        canvas.fill(x, top, 1, bottom - top + 1, line);  // a step is a vertical line
        before = y;
    }
    return canvas.image();
}

}  // namespace shade16::host
