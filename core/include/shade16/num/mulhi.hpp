// Exact multiplies. Each has one definition and two bodies: `wide` for cores with a 32x32->64 multiply, `narrow` for
// ARMv6-M and others that only have 32x32->32. The bits are the same; the unit test compares the bodies.
#pragma once

#include "shade16/num/bits.hpp"

#if !defined(SHADE16_NARROW_MULTIPLY)
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__) || defined(__AVR__) || (defined(__riscv) && !defined(__riscv_mul))
#define SHADE16_NARROW_MULTIPLY 1
#else
#define SHADE16_NARROW_MULTIPLY 0
#endif
#endif

namespace shade16 {

namespace wide {
SHADE16_INLINE constexpr uint64_t multiply(uint32_t a, uint32_t b) { return uint64_t{a} * b; }
SHADE16_INLINE constexpr int64_t multiply(int32_t a, int32_t b) { return int64_t{a} * b; }
SHADE16_INLINE constexpr int64_t multiply(int32_t a, uint32_t b) { return int64_t{a} * int64_t{b}; }
SHADE16_INLINE constexpr uint32_t mulhi(uint32_t a, uint32_t b) { return static_cast<uint32_t>(multiply(a, b) >> 32); }
SHADE16_INLINE constexpr int32_t mulhi(int32_t a, int32_t b) {
    // GCC takes a factor that it knows to be positive for an unsigned one, and has no instruction for that mixture.
    return static_cast<int32_t>(multiply(a, opaque(b)) >> 32);
}
SHADE16_INLINE constexpr int32_t mulhi(int32_t a, uint32_t b) { return static_cast<int32_t>(multiply(a, b) >> 32); }
}  // namespace wide

namespace narrow {
// Not inlined: each call would be fifty instructions. The hot loops use mulhi, which is.
/// Four 16x16 products. Source: schoolbook multiplication in base 2^16.
SHADE16_ONCE constexpr uint64_t multiply(uint32_t a, uint32_t b) {
    const uint32_t a_low = a & 0xFFFF, a_high = a >> 16, b_low = b & 0xFFFF, b_high = b >> 16;
    const uint32_t low = a_low * b_low;
    const uint32_t middle = a_low * b_high + (low >> 16);
    const uint32_t middle2 = a_high * b_low + (middle & 0xFFFF);
    const uint32_t high = a_high * b_high + (middle >> 16) + (middle2 >> 16);
    return (uint64_t{high} << 32) | (middle2 << 16) | (low & 0xFFFF);
}
/// The high word alone.
SHADE16_INLINE constexpr uint32_t mulhi(uint32_t a, uint32_t b) {
    const uint32_t a_low = a & 0xFFFF, a_high = a >> 16, b_low = b & 0xFFFF, b_high = b >> 16;
    const uint32_t middle = a_low * b_high + (a_low * b_low >> 16);
    const uint32_t middle2 = a_high * b_low + (middle & 0xFFFF);
    return a_high * b_high + (middle >> 16) + (middle2 >> 16);
}
/// Two's complement: the unsigned product, less 2^32 times the other operand for each negative one.
constexpr int64_t multiply(int32_t a, uint32_t b) {
    const uint64_t product = multiply(static_cast<uint32_t>(a), b);
    const uint64_t borrow = a < 0 ? b : 0;
    return static_cast<int64_t>(product - (borrow << 32));
}
constexpr int64_t multiply(int32_t a, int32_t b) {
    const uint64_t product = static_cast<uint64_t>(multiply(a, static_cast<uint32_t>(b)));
    const uint64_t borrow = b < 0 ? static_cast<uint32_t>(a) : 0;
    return static_cast<int64_t>(product - (borrow << 32));
}
SHADE16_INLINE constexpr int32_t mulhi(int32_t a, uint32_t b) {
    return static_cast<int32_t>(mulhi(static_cast<uint32_t>(a), b) - (a < 0 ? b : 0));
}
SHADE16_INLINE constexpr int32_t mulhi(int32_t a, int32_t b) {
    return static_cast<int32_t>(mulhi(static_cast<uint32_t>(a), static_cast<uint32_t>(b)) - (a < 0 ? static_cast<uint32_t>(b) : 0) -
                                (b < 0 ? static_cast<uint32_t>(a) : 0));
}
}  // namespace narrow

/// multiply(a, b): the whole product. mulhi(a, b): its high word, floor(a * b / 2^32).
/// Range   any operands, both signed, both unsigned, or a signed one first.
/// Error   none.
/// Cost    M3/M4: one UMULL or SMULL; M0+: four MULS.
#if SHADE16_NARROW_MULTIPLY
using narrow::mulhi;
using narrow::multiply;
#else
using wide::mulhi;
using wide::multiply;
#endif

/// The high word of a 64x64 product: for table builders, never in a hot loop.
constexpr uint64_t mulhi(uint64_t a, uint64_t b) {
    const uint32_t a_low = static_cast<uint32_t>(a), a_high = static_cast<uint32_t>(a >> 32);
    const uint32_t b_low = static_cast<uint32_t>(b), b_high = static_cast<uint32_t>(b >> 32);
    const uint64_t middle = multiply(a_low, b_high) + mulhi(a_low, b_low);
    const uint64_t middle2 = multiply(a_high, b_low) + static_cast<uint32_t>(middle);
    return multiply(a_high, b_high) + (middle >> 32) + (middle2 >> 32);
}

}  // namespace shade16
