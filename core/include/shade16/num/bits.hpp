// Bit-level helpers that every kernel is built from. All are total: no input is undefined.
#pragma once

#include <stddef.h>
#include <stdint.h>

// Inner kernels lose a third of their speed when a compiler decides to call them.
#define SHADE16_INLINE [[gnu::always_inline]] inline
// Set-up code runs once an object and frame: one copy of it, whatever the optimiser thinks.
#define SHADE16_ONCE [[gnu::noinline]]
// Tables are read a few times a vertex or pixel. Where flash makes the processor wait, -DSHADE16_TABLES_IN_RAM puts them among the variables:
// 426 bytes in mediump, and 156 an exponent of the scene. GCC overlooks a section on a template's variable; one that is no constant lies in RAM by itself, and is
// then not for constant expressions.
#if defined(SHADE16_TABLES_IN_RAM)
#define SHADE16_TABLE [[gnu::section(".data.shade16_tables")]] inline constexpr
#define SHADE16_TABLE_OF_TEMPLATE inline constinit
#else
#define SHADE16_TABLE inline constexpr
#define SHADE16_TABLE_OF_TEMPLATE inline constexpr
#endif

namespace shade16 {

/// Leading zeros of a 32-bit word.
/// Range   any x; 32 for x = 0 (the builtin is undefined there).
SHADE16_INLINE constexpr int leading_zeros(uint32_t x) {
    if (x == 0) return 32;
    if constexpr (sizeof(unsigned int) >= 4) return __builtin_clz(static_cast<unsigned int>(x));
    return __builtin_clzl(x);  // AVR: int is 16 bits, long is 32
}

/// Leading zeros of a 64-bit word; 64 for x = 0.
constexpr int leading_zeros(uint64_t x) {
    const uint32_t high = static_cast<uint32_t>(x >> 32);
    return high ? leading_zeros(high) : 32 + leading_zeros(static_cast<uint32_t>(x));
}

/// |x| as an unsigned number, so that INT32_MIN has one.
SHADE16_INLINE constexpr uint32_t magnitude(int32_t x) {
    return x < 0 ? 0u - static_cast<uint32_t>(x) : static_cast<uint32_t>(x);
}
constexpr uint64_t magnitude(int64_t x) {
    return x < 0 ? uint64_t{0} - static_cast<uint64_t>(x) : static_cast<uint64_t>(x);
}

/// x, of which the optimiser shall assume nothing: where what it knows makes it choose worse.
template <class T>
SHADE16_INLINE constexpr T opaque(T x) {
    if (!__builtin_is_constant_evaluated()) asm("" : "+r"(x));
    return x;
}

/// x * 2^n modulo 2^32, n in [0, 31]: the shift that is undefined for negative x before C++20 tools learn it.
SHADE16_INLINE constexpr int32_t shift_left(int32_t x, int n) {
    return static_cast<int32_t>(static_cast<uint32_t>(x) << n);
}

/// x / 2^n rounded half up, n in [0, 31]; never overflows (the rounding bit is added after the shift).
SHADE16_INLINE constexpr int32_t shift_right_round(int32_t x, int n) {
    return n == 0 ? x : (x >> n) + ((x >> (n - 1)) & 1);
}
constexpr int64_t shift_right_round(int64_t x, int n) {
    return n == 0 ? x : (x >> n) + ((x >> (n - 1)) & 1);
}
constexpr uint64_t shift_right_round(uint64_t x, int n) {
    return n == 0 ? x : (x >> n) + ((x >> (n - 1)) & 1u);
}

/// The nearest int32 to x.
SHADE16_INLINE constexpr int32_t saturate(int64_t x) {
    if (x > INT32_MAX) return INT32_MAX;
    if (x < INT32_MIN) return INT32_MIN;
    return static_cast<int32_t>(x);
}

/// x * 2^n for any n, rounded half up when n < 0, saturated when n > 0.
SHADE16_ONCE constexpr int32_t scale_by_power_of_two(int64_t x, int32_t n) {
    if (n < -63) return 0;
    if (n <= 0) return saturate(shift_right_round(x, static_cast<int>(-n)));
    if (x == 0) return 0;
    if (n >= leading_zeros(magnitude(x)) - 1) return x < 0 ? INT32_MIN : INT32_MAX;
    return saturate(static_cast<int64_t>(static_cast<uint64_t>(x) << n));
}

/// What has an order; vectors have none, and take glsl/'s componentwise min and max.
template <class T>
concept Ordered = requires(T a, T b) { a < b; };

template <Ordered T>
SHADE16_INLINE constexpr T min(T a, T b) {
    return b < a ? b : a;
}
template <Ordered T>
SHADE16_INLINE constexpr T max(T a, T b) {
    return a < b ? b : a;
}
template <Ordered T>
SHADE16_INLINE constexpr T clamp(T x, T low, T high) {
    return min(max(x, low), high);
}

}  // namespace shade16
