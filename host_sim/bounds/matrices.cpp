#include "shade16/num/mat.hpp"

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"

namespace shade16::bounds {
namespace {

int32_t entry(const Mat3& m, int row, int column) {
    return column == 0 ? m.row[row].x.raw : column == 1 ? m.row[row].y.raw : m.row[row].z.raw;
}
int32_t component(IVec3 v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
IVec3 column(const Mat3& m, int i) { return {entry(m, 0, i), entry(m, 1, i), entry(m, 2, i)}; }

Wide exact_dot(IVec3 a, IVec3 b) { return Wide{a.x} * b.x + Wide{a.y} * b.y + Wide{a.z} * b.z; }

double product_error(Dice& dice) {
    const Mat3 a = dice.rotation(), b = dice.rotation(), product = a * b;
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            worst =
                larger(worst, std::fabs(entry(product, i, k) -
                                        std::ldexp(static_cast<double>(exact_dot(raw(a.row[i]), column(b, k))), -30)));
        }
    return worst;
}

double transpose_error(Dice& dice) {
    const Mat3 m = dice.rotation(), turned = transpose(m);
    Differences worst;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) worst(entry(turned, i, k), entry(m, k, i));
    return worst;
}

/// Of a result with `extra_bits` more bits, in its units.
double rotated_error(const Mat3& m, IVec3 v, IVec3 got, int extra_bits) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        const double exact = std::ldexp(static_cast<double>(exact_dot(raw(m.row[i]), v)), extra_bits - 30);
        worst = larger(worst, std::fabs(component(got, i) - std::clamp<double>(exact, INT32_MIN, INT32_MAX)));
    }
    return worst;
}

double rotation_error(Dice& dice) {
    const Mat3 m = dice.rotation();
    const IVec3 v = dice.vector();
    const int extra_bits = dice.integer(0, 14);
    const Vec3 q{Q16::from_raw(v.x), Q16::from_raw(v.y), Q16::from_raw(v.z)};
    return larger(rotated_error(m, v, rotate(m, v, extra_bits), extra_bits), rotated_error(m, v, raw(m * q), 0));
}

double axis_error(Dice& dice) {
    const Angle a{dice.word()};
    const auto [s, c] = sincos(a);
    const Mat3 x = rotate_x(a), y = rotate_y(a), z = rotate_z(a);
    Differences worst;
    worst(entry(x, 1, 2), -Wide{s.raw})(entry(x, 2, 1), s.raw)(entry(x, 1, 1), c.raw)(entry(x, 2, 2), c.raw)(
        entry(x, 0, 0), Q30::one)(entry(x, 0, 1), 0)(entry(x, 1, 0), 0);
    worst(entry(y, 0, 2), s.raw)(entry(y, 2, 0), -Wide{s.raw})(entry(y, 0, 0), c.raw)(entry(y, 2, 2), c.raw)(
        entry(y, 1, 1), Q30::one)(entry(y, 0, 1), 0)(entry(y, 2, 1), 0);
    return worst(entry(z, 0, 1), -Wide{s.raw})(entry(z, 1, 0), s.raw)(entry(z, 0, 0), c.raw)(entry(z, 1, 1), c.raw)(
        entry(z, 2, 2), Q30::one)(entry(z, 0, 2), 0)(entry(z, 2, 1), 0);
}

/// There and back again: what a rigid transform and its inverse leave, in ulp of Q16.
double inverse_error(Dice& dice) {
    const auto small = [&] { return Q16::from_raw(dice.number() >> 4); };
    const Mat3x4 m{dice.rotation(), {small(), small(), small()}};
    const Vec3 v{small(), small(), small()}, back = (inverse(m) * m) * v, twice = inverse(m) * (m * v);
    double worst = 0;
    for (const Vec3& got : {back, twice})
        for (int i = 0; i < 3; ++i)
            worst = larger(worst, std::fabs(double{1} * component(raw(got), i) - component(raw(v), i)));
    return worst;
}

}  // namespace

void add_matrices(Entries& to) {
    to.add_random({.name = "Mat3 product",
                   .header = "num/mat.hpp",
                   .functions = "operator*",
                   .unit = "ulp of Q30",
                   .bound = in_ulps(mat3_product_max_error)},
                  product_error);
    to.add_random({.name = "transpose", .header = "num/mat.hpp", .functions = "transpose", .unit = "ulp of Q30"},
                  transpose_error);
    to.add_random({.name = "rotate",
                   .header = "num/mat.hpp",
                   .functions = "rotate operator*",
                   .unit = "ulp of the result",
                   .bound = in_ulps(rotate_max_error)},
                  rotation_error);
    to.add_random({.name = "rotate_x, rotate_y, rotate_z",
                   .header = "num/mat.hpp",
                   .functions = "rotate_x rotate_y rotate_z",
                   .unit = "ulp of Q30, beyond sincos"},
                  axis_error);
    to.add_random({.name = "inverse(Mat3x4)",
                   .header = "num/mat.hpp",
                   .functions = "inverse operator*",
                   .unit = "ulp of Q16, there and back",
                   .bound = in_ulps(inverse_max_error)},
                  inverse_error);
}

}  // namespace shade16::bounds
