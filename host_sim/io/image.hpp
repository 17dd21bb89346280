// Image: one finished frame, as a picture for people and as the bytes that the target would show.
#pragma once

#include <cstdint>
#include <vector>

namespace shade16::host {

struct Image {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb{};  // 3 bytes a pixel
    std::vector<uint8_t> raw{};  // the target's own bytes
    int raw_bits = 0;            // a pixel of `raw`, where that is 8 or less: rows begin on a byte
};

}  // namespace shade16::host
