// The parts of the light that are functions of a few numbers. Vertices hold the whole: vertices.hpp.
#include "shade16/pipeline/light.hpp"

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/relative.hpp"

namespace shade16::bounds {
namespace {

/// Two unit vectors, half of the time close to each other.
struct Pair {
    Normal30 a, b;
    explicit Pair(Dice& dice) : a(dice.direction()), b(dice.direction()) {
        if (dice.below(2) == 0) return;
        const double apart = std::pow(10.0, dice.uniform(-7, 0));
        const auto beside = [apart](Q30 p, Q30 q) {
            return static_cast<int32_t>(std::llround((p.raw + q.raw * apart) / 2));
        };
        b = normalize_finely({beside(a.x, b.x), beside(a.y, b.y), beside(a.z, b.z)});
    }
};
Normal14 narrow(const Normal30& n) {
    const auto rounded = [](Q30 c) { return Unit14::from_raw(shift_right_round(c.raw, 16)); };
    return {rounded(n.x), rounded(n.y), rounded(n.z)};
}

template <class T>
long double exact_dot(const Vector3<T>& a, const Vector3<T>& b) {
    const long double one = T::one;
    return (static_cast<long double>(a.x.raw) * b.x.raw + static_cast<long double>(a.y.raw) * b.y.raw +
            static_cast<long double>(a.z.raw) * b.z.raw) /
           one / one;
}
template <class T>
long double exact_chord(const Vector3<T>& a, const Vector3<T>& b) {
    const auto squared = [](T p, T q) {
        const long double d = (static_cast<long double>(p.raw) - q.raw) / T::one;
        return d * d;
    };
    return (squared(a.x, b.x) + squared(a.y, b.y) + squared(a.z, b.z)) / 2;
}

/// In units of the result, which ends at the last value below `end`.
double units(uint32_t got, long double exact, int fraction_bits, long double end) {
    const long double nearest = std::clamp(std::ldexp(exact, fraction_bits), 0.0L, std::ldexp(end, fraction_bits) - 1);
    return static_cast<double>(std::fabs(got - nearest));
}

double cosine_error(Dice& dice) {
    const Pair p(dice);
    const Normal14 a = narrow(p.a), b = narrow(p.b);
    return larger(units(detail::cosine(p.a, p.b), exact_dot(p.a, p.b), 32, 1),
                  units(detail::cosine(a, b), exact_dot(a, b), 16, 1));
}
double narrow_chord_error(Dice& dice) {
    const Pair p(dice);
    const Normal14 a = narrow(p.a), b = narrow(p.b);
    return units(detail::chord(a, b), exact_chord(a, b), 29, 8);
}
double wide_chord_error(Dice& dice) {
    const Pair p(dice);
    const long double u = exact_chord(p.a, p.b);
    return units(detail::chord(p.a, p.b), u, 32, 1) /
           (detail::wide_chord_max_error * std::sqrt(static_cast<double>(u)) + 1);
}

Scaled any_coefficient(Dice& dice) { return Scaled::normalized(dice.below(65536), -16 - dice.integer(0, 40)); }
double attenuation_error(Dice& dice) {
    const LatticeAttenuation a{true, any_coefficient(dice), any_coefficient(dice), any_coefficient(dice)};
    const Scaled squared{dice.mantissa(), dice.integer(0, 60)};
    const long double d = std::sqrt(wide(squared)),
                      fading = wide(a.constant) + wide(a.linear) * d + wide(a.quadratic) * d * d;
    return fading == 0 ? 0 : relative_error(wide(a.at(squared)), 1 / fading);
}

constexpr Needs ranges = [] {
    Needs n;
    n.range = true;
    return n;
}();
double range_error(Dice& dice) {
    LampShape shape;
    shape.ends = true, shape.inverse_range_squared = {dice.mantissa(), -20};
    const Scaled squared{dice.mantissa(), dice.integer(-10, 24)};
    const long double left = std::fmax(1 - wide(squared) * wide(shape.inverse_range_squared), 0.0L);
    return static_cast<double>(std::fabs(wide(shape.at_distance<ranges>(squared)) - left * left));
}

constexpr Needs spots = [] {
    Needs n;
    n.spot = true;
    return n;
}();
/// Between the angles of a cone, beside them and beyond; given the chord to its axis.
double cone_error(Dice& dice) {
    const long double one = 0x1p61L;
    LampShape shape;
    shape.inner = dice.bits() >> dice.integer(3, 20),
    shape.outer = shape.inner + (dice.bits() >> dice.integer(3, 24)) + 1;
    shape.inverse_width = reciprocal(Scaled::normalized(shape.outer - shape.inner, -61));
    const uint64_t width = shape.outer - shape.inner,
                   u = shape.inner - shape.inner / 8 + dice.bits() % (width + width / 4 + shape.inner / 8 + 1);
    const long double t = std::clamp((shape.outer / one - u / one) / (width / one), 0.0L, 1.0L);
    return static_cast<double>(std::fabs(wide(shape.in_cone<spots>(u)) - t * t * (3 - 2 * t)));
}

}  // namespace

void add_light(Entries& to) {
    const auto entry = [](const char* name, const char* header, const char* unit, double bound) {
        return Entry{.name = name, .header = header, .functions = "", .unit = unit, .bound = bound};
    };
    to.add_random(entry("N.L", "pipeline/light.hpp", "units", detail::cosine_max_error), cosine_error);
    to.add_random(entry("chord, 16-bit vectors", "pipeline/chord.hpp", "2^-29", 0), narrow_chord_error);
    to.add_random(entry("chord, 32-bit vectors", "pipeline/chord.hpp", "of its bound", 1), wide_chord_error);
    to.add_random(entry("attenuation", "pipeline/lattice.hpp", "2^-32 of it", attenuation_max_error),
                  [](Dice& dice) { return attenuation_error(dice) * 0x1p32; });
    to.add_random(entry("range", "pipeline/lamp.hpp", "2^-32", detail::range_max_error),
                  [](Dice& dice) { return range_error(dice) * 0x1p32; });
    to.add_random(entry("cone", "pipeline/lamp.hpp", "2^-32", detail::cone_max_error),
                  [](Dice& dice) { return cone_error(dice) * 0x1p32; });
}

}  // namespace shade16::bounds
