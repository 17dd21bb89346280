#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"

namespace shade16::bounds {
namespace {

/// In units of Q16, of a Q32 number that is brought into range.
double ulps_of_q16(Q16 got, Wide exact_q32) {
    const double exact = std::ldexp(static_cast<double>(exact_q32), -16);
    return std::fabs(got.raw - std::clamp<double>(exact, INT32_MIN, INT32_MAX));
}

double by_component(Dice& dice) {
    const Vec3 a = dice.vec3(), b = dice.vec3();
    const Q16 k = dice.q16();
    const Vec3 sum = a + b, difference = a - b, negative = -a, product = a * k;
    Differences worst;
    worst(sum.x.raw, (a.x + b.x).raw)(sum.y.raw, (a.y + b.y).raw)(sum.z.raw, (a.z + b.z).raw);
    worst(difference.x.raw, (a.x - b.x).raw)(difference.y.raw, (a.y - b.y).raw)(difference.z.raw, (a.z - b.z).raw);
    worst(negative.x.raw, (-a.x).raw)(negative.y.raw, (-a.y).raw)(negative.z.raw, (-a.z).raw);
    worst(product.x.raw, (a.x * k).raw)(product.y.raw, (a.y * k).raw)(product.z.raw, (a.z * k).raw);
    const IVec3 r = raw(a), q = raw(Normal30{{r.x}, {r.y}, {r.z}}), u = raw(Normal14{Unit14::from_raw(r.x), {}, {}});
    return worst(r.x, a.x.raw)(r.y, a.y.raw)(r.z, a.z.raw)(q.x, r.x)(q.y, r.y)(q.z, r.z)(
        u.x, std::clamp(r.x, -32768, 32767))(u.y, 0)(u.z, 0);
}

double unit_dots(Dice& dice) {
    const Normal30 a = dice.direction(), b = dice.direction();
    const auto narrow = [](const Normal30& n) {
        return Normal14{Unit14::from_raw(n.x.raw >> 16), Unit14::from_raw(n.y.raw >> 16),
                        Unit14::from_raw(n.z.raw >> 16)};
    };
    const Normal14 c = narrow(a), d = narrow(b);
    Differences worst;
    worst(dot(a, b), Wide{a.x.raw} * b.x.raw + Wide{a.y.raw} * b.y.raw + Wide{a.z.raw} * b.z.raw);
    return worst(dot(c, d), Wide{c.x.raw} * d.x.raw + Wide{c.y.raw} * d.y.raw + Wide{c.z.raw} * d.z.raw);
}

Wide exact_dot(Vec3 a, Vec3 b) { return Wide{a.x.raw} * b.x.raw + Wide{a.y.raw} * b.y.raw + Wide{a.z.raw} * b.z.raw; }
Wide minor(Q16 a, Q16 b, Q16 c, Q16 d) { return Wide{a.raw} * b.raw - Wide{c.raw} * d.raw; }

double cross_error(Dice& dice) {
    const Vec3 a = dice.vec3(), b = dice.vec3(), c = cross(a, b);
    return larger(ulps_of_q16(c.x, minor(a.y, b.z, a.z, b.y)),
                  larger(ulps_of_q16(c.y, minor(a.z, b.x, a.x, b.z)), ulps_of_q16(c.z, minor(a.x, b.y, a.y, b.x))));
}

}  // namespace

void add_vectors(Entries& to) {
    to.add_random({.name = "Vec3 by component",
                   .header = "num/vec.hpp",
                   .functions = "operator+ operator- operator* raw",
                   .unit = "units"},
                  by_component);
    to.add_random({.name = "dot of unit vectors", .header = "num/vec.hpp", .functions = "dot", .unit = "units"},
                  unit_dots);
    to.add_random({.name = "dot(Vec3)",
                   .header = "num/vec.hpp",
                   .functions = "dot",
                   .unit = "ulp of Q16",
                   .bound = in_ulps(vec3_dot_max_error)},
                  [](Dice& dice) {
                      const Vec3 a = dice.vec3(), b = dice.vec3();
                      return ulps_of_q16(dot(a, b), exact_dot(a, b));
                  });
    to.add_random({.name = "cross(Vec3)",
                   .header = "num/vec.hpp",
                   .functions = "cross",
                   .unit = "ulp of Q16",
                   .bound = in_ulps(vec3_cross_max_error)},
                  cross_error);
}

}  // namespace shade16::bounds
