// golden_pictures <check or bless> <drawn> <golden> <changed>: holds the drawn *.ppm against <golden>_*.png, pixel by
// pixel. Of each frame that differs, <changed>_*_before, _after and _difference.png are left to look at.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <png.h>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/png_chunk.hpp"

namespace shade16::host {
namespace {

Image read_ppm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int largest = 0;
    Image image;
    file >> magic >> image.width >> image.height >> largest;
    file.get();
    image.rgb.assign(std::istreambuf_iterator<char>(file), {});
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (magic != "P6" || image.rgb.size() != 3 * pixels) throw input_error("{}: is no picture.", path);
    return image;
}

/// An image of no size when there is none.
Image read_png(const std::string& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, path.c_str())) return {};
    png.format = PNG_FORMAT_RGB;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}, {}};
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) return {};
    return image;
}

void write_png(const std::string& path, const Image& image) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    const auto stream = open_output(path);
    stream->write(encoded_png(image, path));
    stream->commit();
}

/// Channel by channel; black where both agree, and never dark where they do not, so that one code in one pixel shows.
Image difference(const Image& a, const Image& b) {
    Image result = a;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const int d = std::abs(int{a.rgb[i]} - int{b.rgb[i]});
        result.rgb[i] = static_cast<uint8_t>(d == 0 ? 0 : std::min(255, 128 + 4 * d));
    }
    return result;
}

/// Whether a frame is as it was.
bool is_golden(const Image& drawn, const std::string& golden, const std::string& changed) {
    const Image before = read_png(golden);
    const bool same_size = before.width == drawn.width && before.height == drawn.height;
    if (same_size && before.rgb == drawn.rgb) return true;
    write_png(changed + "_after.png", drawn);
    if (before.width > 0) write_png(changed + "_before.png", before);
    if (same_size) write_png(changed + "_difference.png", difference(before, drawn));
    std::printf("%s: %s; see %s_*.png\n", golden.c_str(), before.width > 0 ? "differs" : "is missing", changed.c_str());
    return false;
}

int run(const std::string& action, const std::string& drawn, const std::string& golden, const std::string& changed) {
    int frames = 0, others = 0;
    for (; std::filesystem::exists(fmt::format("{}/{}.ppm", drawn, frames)); ++frames) {
        const Image image = read_ppm(fmt::format("{}/{}.ppm", drawn, frames));
        const std::string png = fmt::format("{}_{}.png", golden, frames);
        if (is_golden(image, png, fmt::format("{}_{}", changed, frames))) continue;
        ++others;
        if (action == "bless") write_png(png, image);
    }
    if (frames == 0) throw input_error("{}: has no frames.", drawn);
    return action == "check" && others > 0 ? 1 : 0;
}

}  // namespace
}  // namespace shade16::host

int main(int argc, char** argv) {
    if (argc != 5) return 2;
    try {
        return shade16::host::run(argv[1], argv[2], argv[3], argv[4]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "golden_pictures: %s\n", error.what());
        return 2;
    }
}
