// ByteMaps: a texture and a relief with as many texels as they say, so that one look-up beside them is seen by the sanitizer. Sizes and
// fraction bits are always those of a map: nobody checks them a pixel.
#pragma once

#include <vector>

#include "tests/fuzz/byte_fields.hpp"

namespace shade16::fuzz {

class ByteMaps {
public:
    explicit ByteMaps(ByteFields& f) {
        texture_.width_log2 = side_log2(f), texture_.height_log2 = side_log2(f);
        texels_.resize(std::size_t{1} << (texture_.width_log2 + texture_.height_log2));
        for (std::size_t i = 0; i < texels_.size() && i < most_given; ++i) texels_[i] = f.u16();
        texture_.texels = {texels_.data(), static_cast<uint32_t>(texels_.size())};

        relief_.width_log2 = side_log2(f), relief_.height_log2 = side_log2(f);
        slopes_.resize(std::size_t{1} << (relief_.width_log2 + relief_.height_log2));
        for (std::size_t i = 0; i < slopes_.size() && i < most_given; ++i) slopes_[i] = {f.i8(), f.i8()};
        relief_.texels = {slopes_.data(), static_cast<uint32_t>(slopes_.size())};
        relief_.fraction_bits = static_cast<uint8_t>(4 + f.below(8));
    }
    ByteMaps(const ByteMaps&) = delete;
    ByteMaps& operator=(const ByteMaps&) = delete;

    const Texture& texture() const { return texture_; }
    const SlopeMap& relief() const { return relief_; }

private:
    static constexpr std::size_t most_given = 16;  // texels from bytes; the others are 0

    static uint8_t side_log2(ByteFields& f) { return static_cast<uint8_t>(f.is_extreme() ? f.below(12) : f.below(5)); }

    std::vector<uint16_t> texels_{};
    std::vector<Slope8> slopes_{};
    Texture texture_{};
    SlopeMap relief_{};
};

}  // namespace shade16::fuzz
