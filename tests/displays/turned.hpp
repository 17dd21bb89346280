// Pictures as they look when they are turned.
#pragma once

#include <array>

#include "tests/displays/dcs_model.hpp"

namespace shade16::displays {

/// How a picture looks on a glass that it is turned and mirrored for.
inline Seen turned(const Seen& picture, Orientation o) {
    const bool exchanged = o.quarter_turns % 2 != 0;
    Seen seen{exchanged ? picture.height : picture.width, exchanged ? picture.width : picture.height, {}};
    seen.pixels.resize(picture.pixels.size());
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int mx = o.mirrored ? picture.width - 1 - x : x;
            const std::array<std::array<int, 2>, 4> places{{{mx, y}, {seen.width - 1 - y, mx}, {seen.width - 1 - mx, seen.height - 1 - y}, {y, seen.height - 1 - mx}}};
            const auto [u, v] = places[static_cast<size_t>(o.quarter_turns)];
            seen.at(u, v) = picture.at(x, y);
        }
    return seen;
}

}  // namespace shade16::displays
