// Chunks: what a PNG file consists of after its signature.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/io/image.hpp"

namespace shade16::host {

inline constexpr std::string_view png_signature{"\x89PNG\r\n\x1a\n", 8};

/// A whole PNG file of one frame. `path` is for the sentence when that fails.
std::vector<uint8_t> encoded_png(const Image& frame, const std::string& path);

/// The contents of all chunks of one kind, joined.
std::vector<uint8_t> png_contents(std::span<const uint8_t> file, std::string_view kind);

/// Length, kind, contents and checksum.
std::vector<uint8_t> png_chunk(std::string_view kind, std::span<const uint8_t> contents);

/// Most significant byte first, as PNG has all its numbers.
void append_big_endian(std::vector<uint8_t>& bytes, uint32_t value, int byte_count);

}  // namespace shade16::host
