// A precision tier is a promise about the error of a shaded vertex, not a table size. The code picks its arithmetic and
// sizes its tables from the promise, the accuracy tests assert it, and the generated docs print it.
#pragma once

#include "shade16/num/literal.hpp"
#include "shade16/num/unorm.hpp"

namespace shade16 {

/// An amount of error, in millionths of a level; one level is 1/255 of a colour channel.
struct Levels {
    uint32_t micro = 0;
    friend constexpr bool operator==(Levels, Levels) = default;
    friend constexpr bool operator<=(Levels a, Levels b) { return a.micro <= b.micro; }
};
consteval Levels operator""_levels(const char* digits) {
    return {static_cast<uint32_t>(parse_decimal(digits, 1'000'000, 255'000'000))};
}

/// The largest error of a vertex colour, for one light arriving at intensity 1, against double precision on the same
/// integer inputs. Conditions: |L + V| >= 0.5 (below that it grows as 0.5/|L + V|); beside the gate N.L = 0 either side
/// of the specular step is accepted. Several lights: the promise times the sum of their intensities.
struct Promise {
    Levels to_exponent_128, to_exponent_1000;
};

/// How colours step along a span: `packed`, three channels in one word, at most one code of the target away from exact
/// interpolation; `exact`, within exact_stepping_max_error of it before rounding.
enum class Stepping : uint8_t { packed, exact };

struct lowp {
    static constexpr const char* name = "lowp";
    static constexpr Promise promise{1.5_levels, 5_levels};
    static constexpr Stepping stepping = Stepping::packed;
};
struct mediump {
    static constexpr const char* name = "mediump";
    static constexpr Promise promise{0.75_levels, 2.5_levels};
    static constexpr Stepping stepping = Stepping::packed;
};
struct highp {
    static constexpr const char* name = "highp";
    static constexpr Promise promise{0.006_levels, 0.006_levels};
    static constexpr Stepping stepping = Stepping::exact;
};

template <class T>
concept PrecisionTier = requires {
    T::promise.to_exponent_128.micro;
    T::promise.to_exponent_1000.micro;
    T::stepping;
};

/// What the promise makes of the arithmetic. The thresholds are what each form was measured to hold; see docs/DESIGN.md.
template <PrecisionTier Tier>
struct Arithmetic {
    static constexpr uint32_t to_128 = Tier::promise.to_exponent_128.micro, to_1000 = Tier::promise.to_exponent_1000.micro;
    static_assert(to_128 >= highp::promise.to_exponent_128.micro && to_1000 >= highp::promise.to_exponent_1000.micro,
                  "no arithmetic of this engine holds this promise: the smallest is 0.006 levels");

    /// Unit vectors in 32 bits rather than 16.
    static constexpr bool wide = to_128 < mediump::promise.to_exponent_128.micro || to_1000 < mediump::promise.to_exponent_1000.micro;
    /// Index bits of the 1/sqrt table for 16-bit vectors: 49 or 97 entries.
    static constexpr int rsqrt_bits = to_128 >= lowp::promise.to_exponent_128.micro && to_1000 >= lowp::promise.to_exponent_1000.micro ? 6 : 7;
    /// Where |N.L| is below 2^gate_log2 the rounding of unit vectors may put the step of the specular term on either side.
    static constexpr int gate_log2 = wide ? -24 : -12;
    /// The share of the promise that the shininess table may use up.
    static constexpr Levels shininess_max_error{wide ? 1'500 : to_128 / 15 * 4};
};

}  // namespace shade16
