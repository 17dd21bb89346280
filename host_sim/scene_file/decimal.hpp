// Decimals as the core reads them: the same raw integers as from the literals 1.5_q16, 0.3_unorm and 36_deg.
#pragma once

#include <cstdint>
#include <string>

#include "shade16/num/angle.hpp"
#include "shade16/num/q16.hpp"
#include "shade16/num/scaled.hpp"
#include "shade16/num/unorm.hpp"

namespace shade16::host {

/// round(value * scale), half away from zero, of the shortest decimal that reads as `value`: the one that was typed, if
/// it had up to 15 digits. Digits after the ninth decimal are ignored, as in the core.
/// Range   |value| below 2^32, scale up to 2^32.
int64_t times(double value, uint64_t scale);

inline Q16 q16_of(double value) { return Q16::from_raw(saturate(times(value, 65536))); }
inline Q30 q30_of(double value) { return Q30::from_raw(times(value, uint64_t{1} << Q30::fraction_bits)); }
inline Unorm16 unorm_of(double value) { return Unorm16::from_raw(static_cast<uint32_t>(times(value, Unorm16::one))); }
inline Scaled scaled_of(double value) { return Scaled::normalized(static_cast<uint64_t>(times(value, 1u << 24)), -24); }
Angle degrees_of(double value);  // a negative angle is the core's -(x_deg)

/// The shortest decimal that the functions above read as this very value.
std::string decimal(Q16 value);
std::string decimal(Q30 value);
std::string decimal(Unorm16 value);
std::string decimal(Scaled value);
std::string decimal_degrees(Angle value);

/// The shortest decimal between which and `value` the core sees no difference: at most nine decimals.
std::string decimal(double value);

}  // namespace shade16::host
