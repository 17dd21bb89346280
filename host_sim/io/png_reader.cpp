#include "host_sim/io/png_reader.hpp"

#include <filesystem>

#include <png.h>

#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

constexpr unsigned largest_px = 4096;

/// libpng's simplified reader, released on every way out.
struct Reader {
    png_image image{};
    Reader() { image.version = PNG_IMAGE_VERSION; }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_image_free(&image); }
};

}  // namespace

Image read_png(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        throw input_error("{}: there is no such file; expected a picture in PNG format.", path);
    Reader reader;
    if (!png_image_begin_read_from_file(&reader.image, path.c_str()))
        throw input_error("{}: is no picture in PNG format ({}).", path, reader.image.message);
    reader.image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // else 16 bits without a gAMA chunk count as linear, and are bent
    const unsigned width = reader.image.width, height = reader.image.height;
    if (width > largest_px || height > largest_px)
        throw input_error("{}: has {}x{} pixels; expected at most {} a side.", path, width, height, largest_px);
    reader.image.format = PNG_FORMAT_RGBA;  // alpha apart: libpng would blend it with a background
    std::vector<uint8_t> rgba(PNG_IMAGE_SIZE(reader.image));
    if (!png_image_finish_read(&reader.image, nullptr, rgba.data(), 0, nullptr))
        throw input_error("{}: is damaged ({}).", path, reader.image.message);
    Image image{static_cast<int>(width), static_cast<int>(height)};
    image.rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4) image.rgb.insert(image.rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    return image;
}

}  // namespace shade16::host
