#include "host_sim/bounds/entries.hpp"
#include "shade16/num/normalize.hpp"

namespace shade16::bounds {
namespace {

IVec3 any_vector(Dice& dice) {
    if (dice.below(16) != 0) return dice.vector();
    return {dice.integer(-12, 12), dice.integer(-12, 12), dice.integer(-12, 12)};  // a few units long
}

/// The component that is farthest off, in units of `fraction_bits` fraction bits.
double component_error(IVec3 v, IVec3 n, int fraction_bits) {
    if ((v.x | v.y | v.z) == 0) return (n.x | n.y | n.z) == 0 ? 0 : 1e9;
    const long double x = v.x, y = v.y, z = v.z,
                      scale = std::ldexp(1.0L, fraction_bits) / std::sqrt(x * x + y * y + z * z);
    return static_cast<double>(
        larger(std::fabs(n.x - x * scale), larger(std::fabs(n.y - y * scale), std::fabs(n.z - z * scale))));
}

/// The angle between v and n, in units of 2^-fraction_bits radian: what the length's error does not touch.
double angle_error(IVec3 v, IVec3 n, int fraction_bits) {
    if ((v.x | v.y | v.z) == 0) return 0;
    const double x = v.x, y = v.y, z = v.z, length = std::sqrt(x * x + y * y + z * z),
                 one = std::ldexp(1.0, fraction_bits);
    const double ex = x / length * one, ey = y / length * one, ez = z / length * one, dx = n.x - ex, dy = n.y - ey,
                 dz = n.z - ez;
    return std::hypot(dy * ez - dz * ey, dz * ex - dx * ez, dx * ey - dy * ex) / one;
}

template <class Normalize>
void add_form(Entries& to, const char* name, const char* functions, int fraction_bits, double bound, Normalize form) {
    const std::string ulp = "ulp of " + std::string(fraction_bits == 14 ? "Unit14" : "Q30");
    to.add_random({.name = name,
                   .header = "num/normalize.hpp",
                   .functions = functions,
                   .unit = ulp + ", a component",
                   .bound = bound},
                  [=](Dice& dice) {
                      const IVec3 v = any_vector(dice);
                      return component_error(v, form(v), fraction_bits);
                  });
    to.add_random({.name = std::string(name) + ", direction",
                   .header = "num/normalize.hpp",
                   .functions = functions,
                   .unit = ulp + ", the angle",
                   .bound = in_ulps(fraction_bits == 14 ? normalize14_max_angle : normalize30_max_angle)},
                  [=](Dice& dice) {
                      const IVec3 v = any_vector(dice);
                      return angle_error(v, form(v), fraction_bits);
                  });
}

}  // namespace

void add_unit_vectors(Entries& to) {
    add_form(to, "normalize14<6>", "normalize14", 14, in_ulps(normalize14_small_max_error),
             [](IVec3 v) { return raw(normalize14<6>(v)); });
    add_form(to, "normalize14<7>", "normalize14", 14, in_ulps(normalize14_max_error),
             [](IVec3 v) { return raw(normalize14<7>(v)); });
    add_form(to, "normalize30", "normalize30", 30, in_ulps(normalize30_max_error),
             [](IVec3 v) { return raw(normalize30(v)); });
    add_form(to, "normalize_finely", "normalize_finely normalize", 30, in_ulps(normalize_finely_max_error),
             [](IVec3 v) {
                 const IVec3 n = raw(normalize_finely(v));
                 return n == raw(normalize(Vec3{Q16::from_raw(v.x), Q16::from_raw(v.y), Q16::from_raw(v.z)}))
                            ? n
                            : IVec3{INT32_MAX, INT32_MAX, INT32_MAX};
             });
}

}  // namespace shade16::bounds
