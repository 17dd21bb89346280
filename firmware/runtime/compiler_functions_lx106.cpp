// What GCC calls on an LX106 and Debian's libgcc lacks, as the ESP8266 has these functions in its ROM: multiplication and division.
#include <stdint.h>

extern "C" {

/// 64 x 64 -> 64 bits, of one product of 32 x 32 and the low halves of two.
uint64_t __muldi3(uint64_t a, uint64_t b) {
    const auto low = [](uint64_t x) { return static_cast<uint32_t>(x); };
    const auto wide = [](uint32_t x, uint32_t y) {
        const uint32_t xl = x & 0xFFFF, xh = x >> 16, yl = y & 0xFFFF, yh = y >> 16;
        const uint32_t ll = xl * yl, lh = xl * yh, hl = xh * yl, hh = xh * yh;
        const uint32_t middle = (ll >> 16) + (lh & 0xFFFF) + (hl & 0xFFFF);
        return static_cast<uint64_t>(hh + (lh >> 16) + (hl >> 16) + (middle >> 16)) << 32 | (middle << 16 | (ll & 0xFFFF));
    };
    const uint32_t cross = low(a) * low(b >> 32) + low(a >> 32) * low(b);
    return wide(low(a), low(b)) + (static_cast<uint64_t>(cross) << 32);
}

/// Bit by bit. The engine does not divide 64 bits.
uint64_t __udivdi3(uint64_t a, uint64_t b) {
    uint64_t quotient = 0, rest = 0;
    for (int bit = 63; bit >= 0; --bit) {
        rest = rest << 1 | (a >> bit & 1);
        if (rest >= b) rest -= b, quotient |= uint64_t{1} << bit;
    }
    return quotient;
}

/// Bit by bit, as above.
uint32_t __udivsi3(uint32_t a, uint32_t b) {
    uint32_t quotient = 0, rest = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const uint32_t lost = rest >> 31;
        rest = rest << 1 | (a >> bit & 1);
        if (lost != 0 || rest >= b) rest -= b, quotient |= uint32_t{1} << bit;
    }
    return quotient;
}
uint32_t __umodsi3(uint32_t a, uint32_t b) { return a - __udivsi3(a, b) * b; }
int32_t __divsi3(int32_t a, int32_t b) {
    const uint32_t x = a < 0 ? 0u - static_cast<uint32_t>(a) : static_cast<uint32_t>(a), y = b < 0 ? 0u - static_cast<uint32_t>(b) : static_cast<uint32_t>(b);
    const uint32_t quotient = __udivsi3(x, y);
    return static_cast<int32_t>((a < 0) != (b < 0) ? 0u - quotient : quotient);
}
int32_t __modsi3(int32_t a, int32_t b) { return a - __divsi3(a, b) * b; }
}
