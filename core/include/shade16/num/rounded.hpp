// Roots and quotients rounded to the nearest whole number: an estimate from the tables, then the remainder decides.
// Every core gives the same bits, with or without a divider.
#pragma once

#include "shade16/num/reciprocal.hpp"
#include "shade16/num/rsqrt.hpp"

namespace shade16 {

/// sqrt(n), rounded to the nearest.
/// Range   n <= 2^63.  Error  none: half an integer at most.
/// Cost    some eight multiplies and two or three steps of the remainder.
/// Source  sqrt(n) = n / sqrt(n), with two Newton steps for the divisor.
SHADE16_ONCE constexpr uint32_t rounded_root(uint64_t n) {
    if (n == 0) return 0;
    const int zeros = leading_zeros(n) & ~1;
    const uint32_t s = static_cast<uint32_t>((n << zeros) >> 32);
    const uint32_t r = detail::rsqrt_step(rsqrt_newton(s), s);
    uint32_t root = static_cast<uint32_t>(min<uint64_t>(multiply(s, r) >> 31, UINT32_MAX)) >> (zeros / 2);
    while (multiply(root, root) > n) --root;
    while (n - multiply(root, root) > uint64_t{2} * root) ++root;  // (root + 1)^2 <= n
    return n - multiply(root, root) > root ? root + 1 : root;
}

/// n / d, rounded to the nearest, half up.
/// Range   n < d * 2^32, else UINT32_MAX; d = 0 among that.
/// Error   none: half an integer at most.
/// Cost    some eight multiplies and one or two steps of the remainder.
/// Source  an estimate from the reciprocal, twice.
SHADE16_ONCE constexpr uint32_t rounded_quotient(uint64_t n, uint32_t d) {
    if ((n >> 32) >= d) return UINT32_MAX;
    const int zeros = leading_zeros(d);
    const uint32_t r = reciprocal_of_normalized(d << zeros);
    uint64_t q = multiply(static_cast<uint32_t>((n << zeros) >> 32), r) >> 31;
    const uint64_t rest = (n - q * d) << zeros;  // modulo 2^64: the estimate may be too large
    q += static_cast<uint64_t>(multiply(static_cast<int32_t>(rest >> 32), r) >> 31);
    while (q * d > n) --q;
    while (n - q * d >= d) ++q;
    if ((n - q * d) * 2 >= d) ++q;
    return static_cast<uint32_t>(min<uint64_t>(q, UINT32_MAX));
}

}  // namespace shade16
