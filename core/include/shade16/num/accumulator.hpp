// The 8.24 accumulator that every term of the light is rounded into once. Room for 64 lights that add 2.0 each way;
// past 255.99 it stays there, so a brighter lamp never turns dark. Saturation to white comes at the very end, once.
#pragma once

#include "shade16/num/channels.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16 {

template <Channels C>
struct AccumulatorOf {
    static constexpr int fraction_bits = 24;
    static constexpr uint32_t one = uint32_t{1} << fraction_bits;

    uint32_t r = 0, g = 0, b = 0;
};
template <>
struct AccumulatorOf<Channels::luma> {
    static constexpr int fraction_bits = 24;
    static constexpr uint32_t one = uint32_t{1} << fraction_bits;

    uint32_t luma = 0;
};
using Accumulator = AccumulatorOf<Channels::rgb>;

/// sum + term, at most UINT32_MAX.
SHADE16_INLINE constexpr void accumulate(uint32_t& sum, uint32_t term) {
    sum += term;
    if (sum < term) sum = UINT32_MAX;
}

/// product * 2^-shift as a term, rounded down to 2^-24. A negative shift is that of a very strong lamp: saturated.
SHADE16_INLINE constexpr uint32_t scaled_term(uint32_t product, int shift) {
    if (shift >= 0) return shift > 31 ? 0 : product >> shift;
    return leading_zeros(product) >= -shift || product == 0 ? product << min(-shift, 31) : UINT32_MAX;
}

inline constexpr Ulps as_accumulator_max_error = 1.002_ulps;  // of 2^-24; of a luma, which errs itself, a little more than a unit

/// A colour as the accumulator holds it: 65535 becomes exactly 1.0.
/// Range   any.  Error  as_accumulator_max_error.  Cost  two shifts and two additions a channel; of a luma, that of luma_of.
/// Source  c 2^24 / 65535 = c (2^8 + 2^-8 + ..), and a last bit that makes 65535 exactly 1.0.
constexpr uint32_t as_accumulator(Unorm16 c) { return (uint32_t{c.raw} << 8) + (c.raw >> 8) + (c.raw >> 15); }
/// Of each channel, or of the luma alone.  Range, Error, Cost, Source  as above.
template <Channels C = Channels::rgb>
constexpr AccumulatorOf<C> as_accumulator(Rgb c) {
    if constexpr (C == Channels::rgb) {
        return {as_accumulator(c.r), as_accumulator(c.g), as_accumulator(c.b)};
    } else {
        const uint32_t luma = luma_of(c).luma;
        return {(luma >> 8) + (luma >> 31)};  // of a grey just as above
    }
}

}  // namespace shade16
