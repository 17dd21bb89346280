// The smallest rectangle of a frame that differs from the frame before.
#pragma once

#include <algorithm>

#include "host_sim/io/image.hpp"

namespace shade16::host {

struct ChangedPart {
    int x = 0, y = 0;
    Image pixels{};  // `rgb` only
};

/// At least one pixel, also when nothing has changed. Without a frame before, everything has.
inline ChangedPart changed_part(const Image& frame, const Image& before) {
    if (before.rgb.size() != frame.rgb.size()) return {0, 0, {frame.width, frame.height, frame.rgb, {}, 0}};
    const auto at = [&](int x, int y) {
        return 3 * (static_cast<std::ptrdiff_t>(y) * frame.width + static_cast<std::ptrdiff_t>(x));
    };
    int left = frame.width, top = frame.height, right = 0, bottom = 0;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
            if (!std::equal(frame.rgb.begin() + at(x, y), frame.rgb.begin() + at(x, y) + 3,
                            before.rgb.begin() + at(x, y))) {
                left = std::min(left, x), right = std::max(right, x + 1);
                top = std::min(top, y), bottom = std::max(bottom, y + 1);
            }
    if (right == 0) left = top = 0, right = bottom = 1;
    ChangedPart part{left, top, {right - left, bottom - top, {}, {}, 0}};
    for (int y = top; y < bottom; ++y)
        part.pixels.rgb.insert(part.pixels.rgb.end(), frame.rgb.begin() + at(left, y),
                               frame.rgb.begin() + at(right, y));
    return part;
}

}  // namespace shade16::host
