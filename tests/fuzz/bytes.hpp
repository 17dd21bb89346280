// Bytes: any bytes, read one after another; zeros after the last.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shade16::fuzz {

class Bytes {
public:
    Bytes(const uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

    uint8_t u8() { return next_ == end_ ? uint8_t{0} : *next_++; }
    uint16_t u16() {
        const unsigned low = u8();
        return static_cast<uint16_t>(low | unsigned{u8()} << 8);
    }
    uint32_t u32() {
        const uint32_t low = u16();
        return low | uint32_t{u16()} << 16;
    }

    /// 0 to n - 1, n up to 256.
    uint32_t below(uint32_t n) { return u8() * n >> 8; }
    bool one_in(uint32_t n) { return below(n) == n - 1; }  // never after the last byte

private:
    const uint8_t* next_;
    const uint8_t* end_;
};

}  // namespace shade16::fuzz
