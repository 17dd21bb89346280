// The formats; print() and exit() come from console_semihosting.cpp or console_host.cpp.
#include <runtime/console.hpp>

namespace shade16::console {

void print_hex(uint32_t value) {
    char digits[9] = {};
    for (int at = 7; at >= 0; --at, value >>= 4) digits[at] = "0123456789abcdef"[value & 15];
    print(digits);
}

void print_decimal(uint32_t value) {
    // By subtraction: a Cortex-M0 has no divider, and its library one should not look like the engine's doing.
    constexpr uint32_t powers[] = {1000000000, 100000000, 10000000, 1000000, 100000, 10000, 1000, 100, 10, 1};
    char digits[11] = {};
    char* next = digits;
    for (const uint32_t power : powers) {
        char digit = '0';
        for (; value >= power; value -= power) ++digit;
        const bool leading_zero = digit == '0' && next == digits && power != 1;
        if (!leading_zero) *next++ = digit;
    }
    print(digits);
}

void fail(const char* sentence) {
    print(sentence);
    print("\n");
    exit(1);
}

}  // namespace shade16::console
