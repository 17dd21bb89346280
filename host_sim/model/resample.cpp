#include "host_sim/model/resample.hpp"

#include <algorithm>
#include <cmath>

namespace shade16::host {

namespace {

/// The parts of a row of `from` pixels that pixel `index` of `to` covers: first pixel and weights that add up to 1.
struct Cover {
    int first = 0;
    std::vector<double> weights{};

    Cover(int index, int from, int to) {
        const double begin = double(index) * from / to, end = double(index + 1) * from / to;
        first = static_cast<int>(begin);
        for (int i = first; i < from && i < end; ++i)
            weights.push_back((std::min<double>(end, i + 1) - std::max<double>(begin, i)) / (end - begin));
    }
};

}  // namespace

int nearest_power_of_two(int size) {
    const int log2 = static_cast<int>(std::lround(std::log2(std::max(size, 1))));
    return std::min(1 << log2, largest_texture_side);
}

Picture3 resampled(const Image& image, int width, int height) {
    Picture3 result{width, height, {}};
    std::vector<Cover> all_columns;
    for (int x = 0; x < width; ++x) all_columns.emplace_back(x, image.width, width);
    for (int y = 0; y < height; ++y) {
        const Cover rows(y, image.height, height);
        for (const Cover& columns : all_columns) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                double sum = 0;
                for (std::size_t j = 0; j < rows.weights.size(); ++j)
                    for (std::size_t i = 0; i < columns.weights.size(); ++i) {
                        const std::size_t pixel = (static_cast<std::size_t>(rows.first) + j) * static_cast<std::size_t>(image.width) +
                                                  static_cast<std::size_t>(columns.first) + i;
                        sum += rows.weights[j] * columns.weights[i] * image.rgb[3 * pixel + channel];
                    }
                result.values.push_back(sum);
            }
        }
    }
    return result;
}

}  // namespace shade16::host
