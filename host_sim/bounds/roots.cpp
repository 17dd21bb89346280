#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "host_sim/bounds/relative.hpp"
#include "shade16/num/rounded.hpp"

namespace shade16::bounds {
namespace {

constexpr Span mantissas{uint64_t{1} << 30, UINT32_MAX};

/// In units of 2^-32 of it, of a form with `fraction_bits` fraction bits.
double rsqrt_error(uint64_t s, uint32_t got, int fraction_bits) {
    const double exact = std::ldexp(0.5, fraction_bits + 16) / std::sqrt(static_cast<double>(s));
    return std::fabs(got / exact - 1) * 0x1p32;
}

/// Half an integer at most: (2r - 1)^2 <= 4n <= (2r + 1)^2, in integers.
double root_error(uint64_t n) {
    const Wide root = rounded_root(n), four_n = Wide{n} * 4;
    return (2 * root + 1) * (2 * root + 1) >= four_n && (root == 0 || (2 * root - 1) * (2 * root - 1) <= four_n) ? 0
                                                                                                                 : 1;
}
double floor_root_error(uint64_t n) {
    const WideUnsigned root = isqrt(n);
    return root * root <= n && (root + 1) * (root + 1) > n ? 0 : 1;
}

}  // namespace

void add_roots(Entries& to) {
    const auto entry = [](const char* name, const char* functions, double bound) {
        return Entry{.name = name,
                     .header = "num/rsqrt.hpp",
                     .functions = functions,
                     .unit = "2^-32 of it",
                     .bound = bound,
                     .inputs = mantissas};
    };
    to.add(entry("rsqrt_linear<6>", "rsqrt_linear", rsqrt_49_max_error),
           [](uint64_t s) { return rsqrt_error(s, rsqrt_linear<6>(static_cast<uint32_t>(s)), 16); });
    to.add(entry("rsqrt_linear<7>", "rsqrt_linear", rsqrt_97_max_error),
           [](uint64_t s) { return rsqrt_error(s, rsqrt_linear<7>(static_cast<uint32_t>(s)), 16); });
    to.add(entry("rsqrt_newton", "rsqrt_newton", rsqrt_newton_max_error),
           [](uint64_t s) { return rsqrt_error(s, rsqrt_newton(static_cast<uint32_t>(s)), 32); });
    // Every mantissa, at an even and at an odd exponent: others differ by whole powers of two.
    to.add({.name = "sqrt(Scaled)",
            .header = "num/rsqrt.hpp",
            .functions = "sqrt",
            .unit = "of it",
            .bound = scaled_sqrt_max_error * 0x1p-32,
            .inputs = {0, UINT32_MAX}},
           [](uint64_t i) {
               const Scaled x{static_cast<uint32_t>(i) | uint32_t{1} << 31, static_cast<int>(i >> 31)}, root = sqrt(x);
               return relative_error(wide(root), std::sqrt(wide(x)));
           });
    to.add_random({.name = "isqrt", .header = "num/rsqrt.hpp", .functions = "isqrt", .unit = "wrong results"},
                  [](Dice& dice) {
                      const uint64_t n = dice.long_word(), root = dice.word();
                      return floor_root_error(n) + floor_root_error(root * root) +
                             (root == 0 ? 0 : floor_root_error(root * root - 1));
                  });
    to.add({.name = "rounded_root, 32 bits",
            .header = "num/rounded.hpp",
            .functions = "rounded_root",
            .unit = "wrong results"},
           root_error);
    to.add_random(
        {.name = "rounded_root", .header = "num/rounded.hpp", .functions = "rounded_root", .unit = "wrong results"},
        [](Dice& dice) {
            const uint64_t n = dice.long_word() >> 1, root = dice.word() >> 1,
                           between = root * (root + 1);  // where rounding turns
            return root_error(n) + root_error(root * root) + root_error(between) + root_error(between + 1);
        });
    to.add_random({.name = "rounded_quotient",
                   .header = "num/rounded.hpp",
                   .functions = "rounded_quotient",
                   .unit = "wrong results"},
                  [](Dice& dice) {
                      const uint64_t n = dice.long_word();
                      const uint32_t d = dice.word();
                      const Wide wanted = (n >> 32) >= d
                                              ? Wide{UINT32_MAX}
                                              : std::min<Wide>((Wide{n} * 2 + d) / (Wide{d} * 2), UINT32_MAX);
                      return static_cast<double>(Differences()(rounded_quotient(n, d), wanted));
                  });
}

}  // namespace shade16::bounds
