// Pictures brought to powers of two, which the engine's textures are.
#pragma once

#include "host_sim/io/image.hpp"

namespace shade16::host {

/// A picture of doubles, three channels a pixel, in rows from the top.
struct Picture3 {
    int width = 0, height = 0;
    std::vector<double> values{};

    const double* at(int x, int y) const { return &values[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))]; }
};

inline constexpr int largest_texture_side = 1024;

/// The nearest power of two by ratio, at most largest_texture_side.
int nearest_power_of_two(int size);

/// Each pixel of the result is the mean of the part of the picture that it covers.
Picture3 resampled(const Image& image, int width, int height);

}  // namespace shade16::host
