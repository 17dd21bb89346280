#include "host_sim/io/png_chunk.hpp"

#include <png.h>
#include <zlib.h>

#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

constexpr std::size_t number_bytes = 4, kind_bytes = 4;

std::size_t number_at(std::span<const uint8_t> bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < number_bytes; ++i) value = value << 8 | bytes[at + i];
    return value;
}

}  // namespace

std::vector<uint8_t> encoded_png(const Image& frame, const std::string& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(frame.width);
    png.height = static_cast<png_uint_32>(frame.height);
    png.format = PNG_FORMAT_RGB;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<uint8_t> bytes(size);
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, frame.rgb.data(), 0, nullptr))
        throw io_error("{}: cannot be encoded as PNG: {}.", path, png.message);
    bytes.resize(size);
    return bytes;
}

std::vector<uint8_t> png_contents(std::span<const uint8_t> file, std::string_view kind) {
    constexpr std::size_t overhead = number_bytes + kind_bytes + number_bytes;
    std::vector<uint8_t> contents;
    for (std::size_t at = png_signature.size(); at + overhead <= file.size();) {
        const std::size_t length = number_at(file, at);
        const auto begin = file.begin() + static_cast<std::ptrdiff_t>(at + number_bytes + kind_bytes);
        if (std::string_view(reinterpret_cast<const char*>(file.data()) + at + number_bytes, kind_bytes) == kind)
            contents.insert(contents.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
        at += overhead + length;
    }
    return contents;
}

std::vector<uint8_t> png_chunk(std::string_view kind, std::span<const uint8_t> contents) {
    std::vector<uint8_t> bytes;
    append_big_endian(bytes, static_cast<uint32_t>(contents.size()), 4);
    bytes.insert(bytes.end(), kind.begin(), kind.end());
    bytes.insert(bytes.end(), contents.begin(), contents.end());
    const uLong sum = crc32(0, bytes.data() + number_bytes, static_cast<uInt>(bytes.size() - number_bytes));
    append_big_endian(bytes, static_cast<uint32_t>(sum), 4);
    return bytes;
}

void append_big_endian(std::vector<uint8_t>& bytes, uint32_t value, int byte_count) {
    for (int i = byte_count - 1; i >= 0; --i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

}  // namespace shade16::host
