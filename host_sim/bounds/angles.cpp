#include <numbers>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/arc.hpp"

namespace shade16::bounds {
namespace {

double radians(uint64_t turns) { return static_cast<double>(turns) * (std::numbers::pi / 2147483648.0); }
uint64_t mod_turn(Wide x) { return static_cast<uint32_t>(x); }

double angle_sums(Dice& dice) {
    const Angle a{dice.word()}, b{dice.word()};
    const uint32_t n = dice.word();
    Angle c = a;
    c += b;
    Differences worst;
    worst((a + b).turns, mod_turn(Wide{a.turns} + b.turns))((a - b).turns, mod_turn(Wide{a.turns} - b.turns))(
        (-a).turns, mod_turn(-Wide{a.turns}));
    return worst((a * n).turns, mod_turn(Wide{a.turns} * n))(a.half().turns, a.turns / 2)(c.turns, (a + b).turns);
}

struct Direction {
    long double x, y, z;
};
Direction wide(const Normal30& n) { return {n.x.raw * 0x1p-30L, n.y.raw * 0x1p-30L, n.z.raw * 0x1p-30L}; }

/// Two directions as an arc's users have them: rounded, at any angle, also hardly any and nearly half a turn.
struct ArcCase {
    Normal30 a, b;
    explicit ArcCase(Dice& dice) : a(dice.direction()), b(dice.direction()) {
        const uint32_t kind = dice.below(4);
        if (kind == 0) return;
        const long double off = std::pow(10.0L, static_cast<long double>(dice.uniform(-8, 0))),
                          sign = kind == 1 ? -1 : 1;
        const Direction p = wide(a), q = wide(b);
        const long double x = p.x * sign + q.x * off, y = p.y * sign + q.y * off, z = p.z * sign + q.z * off,
                          length = std::sqrt(x * x + y * y + z * z);
        const auto rounded = [length](long double v) {
            return Q30::from_raw(std::llround(std::ldexp(v / length, 30)));
        };
        b = {rounded(x), rounded(y), rounded(z)};
    }
};

/// Rounded vectors make no plane: the arc begins at the first, and every point of it is a unit vector.
double degenerate_arc_error(const Arc& arc, const ArcCase& c, int32_t t) {
    const IVec3 first = arc.at(0), at = arc.at(t);
    const Direction p = wide(Normal30{{at.x}, {at.y}, {at.z}});
    const long double beginning = std::fmax(std::fabs(static_cast<long double>(first.x) - c.a.x.raw),
                                            std::fmax(std::fabs(static_cast<long double>(first.y) - c.a.y.raw),
                                                      std::fabs(static_cast<long double>(first.z) - c.a.z.raw)));
    return static_cast<double>(
        std::fmax(beginning, std::fabs(std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 1) * 0x1p30L));
}

/// In 2^-32 turn, of what three roundings leave of a sine as small as a unit or as large as 1.
double angle_error(Dice& dice) {
    const ArcCase c(dice);
    const Direction a = wide(c.a), b = wide(c.b);
    const long double dot = a.x * b.x + a.y * b.y + a.z * b.z;
    const long double x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
    const long double exact =
        std::atan2(std::sqrt(x * x + y * y + z * z), dot) / std::numbers::pi_v<long double> * 0x1p31L;
    return static_cast<double>(std::fabs(Arc(c.a, c.b).angle().turns - exact));
}

/// Of a sine and cosine that are a little off, as rounding leaves them; a negative sine counts as 0.
double arctangent_error(Dice& dice) {
    const long double angle = static_cast<long double>(radians(dice.bits() >> 33));
    const auto rounded = [&](long double v) {
        return static_cast<int32_t>(std::llround(v * 0x1p30L)) + dice.integer(-4, 4);
    };
    const int32_t y = rounded(std::sin(angle)), x = rounded(std::cos(angle)), up = std::max(y, 0);
    const long double exact = up == 0 && x == 0
                                  ? 0
                                  : std::atan2(static_cast<long double>(up), static_cast<long double>(x)) /
                                        std::numbers::pi_v<long double> * 0x1p31L;
    return static_cast<double>(std::fabs(arctangent({y}, {x}).turns - exact));
}

/// How far `at` leaves the exact great circle's point, in ulp of Q30 of a radian, beyond what the plane itself is
/// uncertain by.
double arc_error(Dice& dice) {
    const ArcCase c(dice);
    const Arc arc(c.a, c.b);
    const int32_t t = static_cast<int32_t>(dice.below((uint32_t{1} << 30) + 1));
    const Direction a = wide(c.a), b = wide(c.b);
    const long double dot = a.x * b.x + a.y * b.y + a.z * b.z;
    const long double ox = b.x - dot * a.x, oy = b.y - dot * a.y, oz = b.z - dot * a.z,
                      sine = std::sqrt(ox * ox + oy * oy + oz * oz);
    if (sine < 1e-7L) return degenerate_arc_error(arc, c, t);
    const long double angle = std::atan2(sine, dot), w = angle * std::ldexp(static_cast<long double>(t), -30),
                      s = std::sin(w) / sine, k = std::cos(w);
    const IVec3 got = arc.at(t);
    const long double dx = got.x * 0x1p-30L - (a.x * k + ox * s), dy = got.y * 0x1p-30L - (a.y * k + oy * s),
                      dz = got.z * 0x1p-30L - (a.z * k + oz * s);
    const long double uncertain = angle < 1 ? 1 : 1 / std::fmin(1.0L, sine);
    return static_cast<double>(std::sqrt(dx * dx + dy * dy + dz * dz) * 0x1p30L / uncertain);
}

}  // namespace

void add_angles(Entries& to) {
    to.add_random({.name = "Angle",
                   .header = "num/angle.hpp",
                   .functions = "Angle::operator+ Angle::operator- Angle::operator* Angle::operator+= Angle::half",
                   .unit = "2^-32 turn"},
                  angle_sums);
    static constexpr int64_t written[] = {(45_deg).turns, (0.1_deg).turns, (359.9_deg).turns, (0.125_turn).turns,
                                          (0.3_turn).turns};
    static constexpr double meant[] = {0.125, 0.1 / 360, 359.9 / 360, 0.125, 0.3};
    to.add({.name = "Angle literals",
            .header = "num/angle.hpp",
            .functions = "operator\"\"_deg operator\"\"_turn",
            .unit = "2^-32 turn",
            .bound = in_ulps(degrees_literal_max_error),
            .inputs = {0, std::size(written) - 1}},
           [](uint64_t i) { return std::fabs(static_cast<double>(written[i]) - meant[i] * 4294967296.0); });
    to.add({.name = "sincos",
            .header = "num/angle.hpp",
            .functions = "sincos sin cos",
            .unit = "ulp of Q30",
            .bound = in_ulps(sincos_max_error)},
           [](uint64_t turns) {
               const Angle a{static_cast<uint32_t>(turns)};
               const SinCos got = sincos(a);
               if (sin(a) != got.sin || cos(a) != got.cos) return 1e9;
               const double x = radians(turns);
               return larger(std::fabs(got.sin.raw - std::sin(x) * 0x1p30),
                             std::fabs(got.cos.raw - std::cos(x) * 0x1p30));
           });
    to.add({.name = "arctangent",
            .header = "num/arc.hpp",
            .functions = "arctangent",
            .unit = "2^-32 turn",
            .bound = in_ulps(arctangent_max_error),
            .inputs = {0, uint64_t{1} << 31}},
           [](uint64_t turns) {
               const double x = radians(turns);
               const int32_t sine = static_cast<int32_t>(std::lround(std::sin(x) * 0x1p30)),
                             cosine = static_cast<int32_t>(std::lround(std::cos(x) * 0x1p30));
               const double exact = std::atan2(sine, cosine) / std::numbers::pi * 2147483648.0;
               return std::fabs(arctangent({sine}, {cosine}).turns - exact);
           });
    to.add_random({.name = "Arc",
                   .header = "num/arc.hpp",
                   .functions = "Arc::at",
                   .unit = "ulp of Q30",
                   .bound = in_ulps(arc_max_error)},
                  arc_error);
    to.add_random({.name = "Arc::angle",
                   .header = "num/arc.hpp",
                   .functions = "Arc::angle",
                   .unit = "2^-32 turn",
                   .bound = in_ulps(arc_angle_max_error)},
                  angle_error);
    to.add_random({.name = "arctangent, rounded operands",
                   .header = "num/arc.hpp",
                   .functions = "arctangent",
                   .unit = "2^-32 turn",
                   .bound = in_ulps(arctangent_max_error)},
                  arctangent_error);
}

}  // namespace shade16::bounds
