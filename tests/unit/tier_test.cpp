#include "shade16/num/tier.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "shade16/num/shininess.hpp"

namespace shade16 {
namespace {

// A user's tiers. Each must be a type at namespace scope, like the built-in ones.
struct fourth {
    static constexpr Promise promise{0.3_levels, 1.0_levels};
    static constexpr Stepping stepping = Stepping::exact;
};
struct only_sharp_highlights {
    static constexpr Promise promise{5_levels, 2.4_levels};
    static constexpr Stepping stepping = Stepping::packed;
};
struct just_mediump {
    static constexpr Promise promise{1.49_levels, 5_levels};
    static constexpr Stepping stepping = Stepping::packed;
};
struct no_tier {};

static_assert(PrecisionTier<lowp> && PrecisionTier<mediump> && PrecisionTier<highp> && PrecisionTier<fourth> && !PrecisionTier<no_tier>);

TEST(Tier, APromiseBelowMediumpTakesWideArithmetic) {
    static_assert(Arithmetic<fourth>::wide && Arithmetic<highp>::wide);
    static_assert(Arithmetic<only_sharp_highlights>::wide, "one of the two numbers is enough");
    static_assert(!Arithmetic<mediump>::wide && !Arithmetic<lowp>::wide && !Arithmetic<just_mediump>::wide);
}

TEST(Tier, APromiseBelowLowpTakesTheLargerTable) {
    static_assert(Arithmetic<lowp>::rsqrt_bits == 6);
    static_assert(Arithmetic<mediump>::rsqrt_bits == 7 && Arithmetic<just_mediump>::rsqrt_bits == 7);
}

TEST(Tier, TheShininessTableUsesAShareOfThePromise) {
    static_assert(Arithmetic<lowp>::shininess_max_error <= lowp::promise.to_exponent_128);
    static_assert(Arithmetic<mediump>::shininess_max_error <= mediump::promise.to_exponent_128);
    static_assert(Arithmetic<highp>::shininess_max_error <= highp::promise.to_exponent_128);
    static_assert(Arithmetic<lowp>::shininess_max_error == 0.4_levels && Arithmetic<mediump>::shininess_max_error == 0.2_levels);
}

TEST(Tier, TheShininessKernelFollowsTheArithmetic) {
    static_assert(std::is_same_v<Shininess<fourth>, ShininessShared> && std::is_same_v<Shininess<highp>, ShininessShared>);
    static_assert(!std::is_same_v<Shininess<mediump>, ShininessShared>);
    static_assert(sizeof(Shininess<lowp>) < sizeof(Shininess<mediump>), "a weaker promise is a smaller table");
}

}  // namespace
}  // namespace shade16
