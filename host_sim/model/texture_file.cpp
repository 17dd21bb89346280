#include "host_sim/model/texture_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "host_sim/error.hpp"
#include "host_sim/io/png_reader.hpp"
#include "host_sim/model/resample.hpp"

namespace shade16::host {

namespace {

constexpr double steepest = 8;
constexpr int least_slope_bits = 4, most_slope_bits = 11;

uint8_t log2_of(int power_of_two) { return static_cast<uint8_t>(std::countr_zero(static_cast<unsigned>(power_of_two))); }

Picture3 read_resampled(const std::string& path, std::vector<std::string>& warnings) {
    const Image image = read_png(path);
    const int width = nearest_power_of_two(image.width), height = nearest_power_of_two(image.height);
    if (width != image.width || height != image.height)
        warnings.push_back(fmt::format("The picture '{}' of {}x{} pixels was brought to {}x{}: textures have powers of two.",
                                       std::filesystem::path(path).filename().string(), image.width, image.height, width, height));
    return resampled(image, width, height);
}

/// Row t of a texture is counted from below.
const double* texel(const Picture3& picture, int s, int t) {
    const auto wrapped = [](int i, int size) { return i & (size - 1); };
    return picture.at(wrapped(s, picture.width), picture.height - 1 - wrapped(t, picture.height));
}

uint16_t rgb565(const double* c) {
    const auto code = [](double value, int largest) { return static_cast<unsigned>(std::lround(std::clamp(value / 255, 0.0, 1.0) * largest)); };
    return static_cast<uint16_t>(code(c[0], 31) << 11 | code(c[1], 63) << 5 | code(c[2], 31));
}

bool is_grey(const Picture3& picture) {
    for (std::size_t i = 0; i < picture.values.size(); i += 3)
        if (picture.values[i] != picture.values[i + 1] || picture.values[i] != picture.values[i + 2]) return false;
    return true;
}

struct Slopes {
    double s = 0, t = 0;
};

/// Uphill to the right the normal leans to the left: n.x / n.z = -dh/ds.
Slopes slopes_of_heights(const Picture3& p, int x, int y, double strength) {
    const auto height = [&](int s, int t) { return texel(p, s, t)[0] / 255; };
    const double factor = strength / 16 / 2;
    return {-factor * p.width * (height(x + 1, y) - height(x - 1, y)), -factor * p.width * (height(x, y + 1) - height(x, y - 1))};
}

Slopes slopes_of_normal(const Picture3& p, int x, int y, double strength) {
    const double* c = texel(p, x, y);
    const auto component = [](double code) { return std::abs(code - 127.5) < 1 ? 0 : code / 127.5 - 1; };  // 127 and 128 both mean none
    const double up = std::max(component(c[2]), 1 / 64.0);
    return {strength * component(c[0]) / up, strength * component(c[1]) / up};
}

}  // namespace

std::shared_ptr<const TextureFile> read_texture(const std::string& path, std::vector<std::string>& warnings) {
    const Picture3 picture = read_resampled(path, warnings);
    auto file = std::make_shared<TextureFile>();
    file->path = path, file->name = std::filesystem::path(path).stem().string();
    for (int t = 0; t < picture.height; ++t)
        for (int s = 0; s < picture.width; ++s) file->texels.push_back(rgb565(texel(picture, s, t)));
    file->texture = {{file->texels.data(), static_cast<uint32_t>(file->texels.size())}, log2_of(picture.width), log2_of(picture.height)};
    return file;
}

std::shared_ptr<const ReliefFile> read_relief(const std::string& path, double strength, ReliefKind kind, std::vector<std::string>& warnings) {
    const Picture3 picture = read_resampled(path, warnings);
    const bool heights = kind == ReliefKind::heights || (kind == ReliefKind::automatic && is_grey(picture));
    std::vector<Slopes> slopes;
    double largest = 0;
    bool is_too_steep = false;
    for (int t = 0; t < picture.height; ++t)
        for (int s = 0; s < picture.width; ++s) {
            Slopes slope = heights ? slopes_of_heights(picture, s, t, strength) : slopes_of_normal(picture, s, t, strength);
            is_too_steep = is_too_steep || std::max(std::abs(slope.s), std::abs(slope.t)) > steepest;
            slope = {std::clamp(slope.s, -steepest, steepest), std::clamp(slope.t, -steepest, steepest)};
            largest = std::max({largest, std::abs(slope.s), std::abs(slope.t)});
            slopes.push_back(slope);
        }
    auto file = std::make_shared<ReliefFile>();
    file->path = path, file->name = std::filesystem::path(path).stem().string(), file->strength = strength, file->kind = kind;
    if (is_too_steep) warnings.push_back(fmt::format("The relief '{}' is steeper than 8 in places, and is drawn with 8 there.", file->name));

    int bits = most_slope_bits;
    while (bits > least_slope_bits && std::ldexp(largest, bits) > 127) --bits;
    const auto rounded = [&](double v) { return static_cast<int8_t>(std::clamp(std::lround(std::ldexp(v, bits)), -127L, 127L)); };
    for (const Slopes& slope : slopes) file->texels.push_back({rounded(slope.s), rounded(slope.t)});
    file->map = {{file->texels.data(), static_cast<uint32_t>(file->texels.size())}, log2_of(picture.width), log2_of(picture.height), static_cast<uint8_t>(bits)};
    return file;
}

}  // namespace shade16::host
