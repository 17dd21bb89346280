// The kernels of core/num but for vectors: multiplies, roots, quotients, powers, and what holds mantissa and exponent.
#include "shade16/num/accumulator.hpp"
#include "shade16/num/channels.hpp"
#include "shade16/num/rounded.hpp"
#include "shade16/num/scaled_power.hpp"
#include "shade16/num/shininess.hpp"

#include "tests/identity/kernels.hpp"

namespace shade16::identity {

namespace {

void run_multiplies(const KernelRun& run) {
    const auto pair = [](Numbers& n) { return Both{n.any(), n.any()}; };
    const auto signed_pair = [](Numbers& n) { return Both{n.any_signed(), n.any_signed()}; };
    const auto mixed_pair = [](Numbers& n) { return Both{n.any_signed(), n.any()}; };

    run("multiply_unsigned", [=](Numbers& n) { const auto [a, b] = pair(n); return multiply(a, b); });
    run("multiply_signed", [=](Numbers& n) { const auto [a, b] = signed_pair(n); return multiply(a, b); });
    run("multiply_mixed", [=](Numbers& n) { const auto [a, b] = mixed_pair(n); return multiply(a, b); });
    run("mulhi_unsigned", [=](Numbers& n) { const auto [a, b] = pair(n); return mulhi(a, b); });
    run("mulhi_signed", [=](Numbers& n) { const auto [a, b] = signed_pair(n); return mulhi(a, b); });
    run("mulhi_mixed", [=](Numbers& n) { const auto [a, b] = mixed_pair(n); return mulhi(a, b); });
    run("mulhi_64", [](Numbers& n) { const Both x{n.any64(), n.any64()}; return mulhi(x.a, x.b); });
    // The bodies that this machine does not use by itself.
    run("multiply_both_bodies", [=](Numbers& n) {
        const auto [a, b] = signed_pair(n);
        return Both{wide::multiply(a, b), narrow::multiply(a, b)};
    });
    run("mulhi_both_bodies", [=](Numbers& n) {
        const auto [a, b] = mixed_pair(n);
        return Both{wide::mulhi(a, b), narrow::mulhi(a, b)};
    });
}

void run_shifts(const KernelRun& run) {
    run("leading_zeros", [](Numbers& n) {
        const Both x{n.any(), n.any64()};
        return Both{static_cast<int32_t>(leading_zeros(x.a)), static_cast<int32_t>(leading_zeros(x.b))};
    });
    run("shift_right_round", [](Numbers& n) {
        const Both x{n.any_signed(), n.below(32)};
        return shift_right_round(x.a, static_cast<int>(x.b));
    });
    run("shift_right_round_64", [](Numbers& n) {
        const Both x{n.any_signed64(), n.below(64)};
        return shift_right_round(x.a, static_cast<int>(x.b));
    });
    run("scale_by_power_of_two", [](Numbers& n) {
        const Both x{n.any_signed64(), n.below(160)};
        return scale_by_power_of_two(x.a, static_cast<int>(x.b) - 80);
    });
    run("q16_sum_and_difference", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return Both{x.a + x.b, x.a - x.b}; });
    run("q16_product", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return x.a * x.b; });
}

void run_roots(const KernelRun& run) {
    const auto mantissa = [](Numbers& n) { return n.mantissa() >> n.below(2); };  // in [2^30, 2^32)

    run("rsqrt_linear_6", [=](Numbers& n) { return rsqrt_linear<6>(mantissa(n)); });
    run("rsqrt_linear_7", [=](Numbers& n) { return rsqrt_linear<7>(mantissa(n)); });
    run("rsqrt_newton", [=](Numbers& n) { return rsqrt_newton(mantissa(n)); });
    run("rsqrt_two_steps", [=](Numbers& n) { const uint32_t s = mantissa(n); return detail::rsqrt_step(rsqrt_newton(s), s); });
    run("sqrt_scaled", [](Numbers& n) { return sqrt(n.scaled()); });
    run("isqrt", [](Numbers& n) { return isqrt(n.any64()); }, Pace::slow);
    run("rounded_root", [](Numbers& n) { return rounded_root(min<uint64_t>(n.any64(), uint64_t{1} << 63)); });
}

void run_quotients(const KernelRun& run) {
    run("reciprocal_of_normalized", [](Numbers& n) { return reciprocal_of_normalized(n.mantissa()); });
    run("reciprocal_scaled", [](Numbers& n) { return reciprocal(n.scaled()); });
    run("quotient", [](Numbers& n) { const Both x{n.any(), n.any()}; return quotient(x.a, x.b); });
    run("quotient_by_reciprocal", [](Numbers& n) {
        const Both x{n.any(), max<uint32_t>(n.any(), 1)};
        return detail::quotient_by_reciprocal(x.a, x.b);
    });
    run("floor_quotient", [](Numbers& n) { const Both x{n.any_signed(), n.any()}; return floor_quotient(x.a, x.b); });
    run("rounded_quotient", [](Numbers& n) { const Both x{n.any64(), n.any()}; return rounded_quotient(x.a, x.b); });
}

void run_scaled(const KernelRun& run) {
    run("scaled_normalized", [](Numbers& n) {
        const Both x{n.any64(), n.below(65536)};
        return Scaled::normalized(x.a, static_cast<int>(static_cast<int32_t>(x.b) - 32768));
    });
    run("scaled_sum", [](Numbers& n) { const Both x{n.scaled(), n.scaled()}; return x.a + x.b; });
    run("scaled_product", [](Numbers& n) { const Both x{n.scaled(), n.scaled()}; return x.a * x.b; });
    run("scaled_to_fixed", [](Numbers& n) {
        const Both x{n.scaled(), n.below(64)};
        return x.a.to_fixed(static_cast<int>(x.b));
    });
}

void run_powers(const KernelRun& run) {
    run("negative_log2", [](Numbers& n) { return negative_log2(max<uint64_t>(n.any64(), 1)); }, Pace::slow);
    run("exp2_negative", [](Numbers& n) { return exp2_negative(n.any64()); }, Pace::slow);
    run("times_q16", [](Numbers& n) { const Both x{n.any64(), n.any()}; return times_q16(x.a, x.b); });
    const auto complement = [](Numbers& n) { const Both x{n.any(), n.any()}; return power_of_complement(x.a, x.b); };
    run("power_of_complement", complement, Pace::slow);
    run("log2_of_normalized", [](Numbers& n) { return detail::log2_of_normalized(n.mantissa()); });
    run("exp2_of_fraction", [](Numbers& n) { return detail::scaled_exp2_of_fraction(n.any()); });
    run("scaled_power", [](Numbers& n) {
        const Both x{n.scaled(), n.any_signed()};
        const uint32_t fraction_bits = n.below(32);
        return power(x.a, x.b, static_cast<int>(fraction_bits));
    });
}

/// (1 - u)^n with an exponent, and so a table, that changes every 4096 arguments.
template <PrecisionTier Tier>
class ShininessPower {
public:
    constexpr uint32_t operator()(Numbers& n) {
        if (turn_++ % 4096 == 0) kernel_ = shininess<Tier>(Q16::from_raw(static_cast<int32_t>(n.bits() >> n.below(14) >> 5)));
        return kernel_.power(Arithmetic<Tier>::wide ? n.any() : n.any() >> n.below(5));
    }

private:
    Shininess<Tier> kernel_{};
    uint32_t turn_ = 0;
};

void run_shininess(const KernelRun& run) {
    run("shininess_lowp", ShininessPower<lowp>{});
    run("shininess_mediump", ShininessPower<mediump>{});
    run("shininess_highp", ShininessPower<highp>{});
}

void run_colors(const KernelRun& run) {
    const auto rgb_of = [](uint32_t a, uint32_t b) {
        return Rgb{Unorm16::from_raw(a & 0xFFFF), Unorm16::from_raw(a >> 16), Unorm16::from_raw(b >> 16)};
    };
    run("luma", [=](Numbers& n) { const Both x{n.any(), n.any()}; return luma_of(rgb_of(x.a, x.b)).luma; });
    run("luma_of_factor", [](Numbers& n) { return as_factor<Channels::luma>(ColorFactor{n.any(), n.any(), n.any()}).luma; });
    run("as_accumulator", [=](Numbers& n) {
        const Both x{n.any(), n.any()};
        const Accumulator a = as_accumulator(rgb_of(x.a, x.b));
        return ColorFactor{a.r, a.g, a.b};
    });
    run("scaled_term", [](Numbers& n) {
        const Both x{n.any(), n.below(100)};
        return scaled_term(x.a, static_cast<int>(x.b) - 50);
    });
    run("accumulate", [](Numbers& n) {
        Both x{n.any(), n.any()};
        accumulate(x.a, x.b);
        return x.a;
    });
}

}  // namespace

void say_number_kernels(Inputs inputs) {
    const KernelRun run("number", inputs);
    run_multiplies(run), run_shifts(run), run_roots(run), run_quotients(run);
    run_scaled(run), run_powers(run), run_shininess(run), run_colors(run);
}

}  // namespace shade16::identity
