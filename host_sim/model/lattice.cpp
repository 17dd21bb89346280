#include "host_sim/model/lattice.hpp"

namespace shade16::host {

namespace {

constexpr int most_fraction_bits = 30;
constexpr double largest_code = 32767;

struct Box {
    Double3 low, high;
};

Box box_of(const std::vector<Double3>& positions) {
    Box box{positions.at(0), positions.at(0)};
    for (const Double3& p : positions)
        for (std::size_t i = 0; i < 3; ++i) {
            box.low[i] = std::min(box.low[i], p[i]);
            box.high[i] = std::max(box.high[i], p[i]);
        }
    return box;
}

bool holds(const Lattice& lattice, const Box& box) {
    const Double3 centre = lattice.centre_value();
    for (std::size_t i = 0; i < 3; ++i) {
        const double farthest = std::max(box.high[i] - centre[i], centre[i] - box.low[i]);
        if (std::round(std::ldexp(farthest, lattice.fraction_bits)) > largest_code) return false;
    }
    return true;
}

/// Exact to a millionth of a step: decimal fractions such as 0.140625 pass through a reader that rounds.
bool is_exact(const Lattice& lattice, const std::vector<Double3>& positions) {
    return std::all_of(positions.begin(), positions.end(), [&](const Double3& p) {
        return std::all_of(p.begin(), p.end(), [&](double x) {
            const double scaled = std::ldexp(x, lattice.fraction_bits);
            return std::fabs(scaled - std::round(scaled)) < 1e-6;
        });
    });
}

Q16 rounded_to(double x, int fraction_bits) {
    const int bits = std::min(fraction_bits, 16);
    return Q16::from_raw(static_cast<int32_t>(std::ldexp(std::round(std::ldexp(x, bits)), 16 - bits)));
}

Lattice about_middle(const Box& box, int fraction_bits) {
    const Double3 middle = (box.low + box.high) * 0.5;
    const auto rounded = [&](std::size_t i) { return rounded_to(middle[i], fraction_bits); };
    return {{rounded(0), rounded(1), rounded(2)}, fraction_bits};
}

}  // namespace

Double3 Lattice::centre_value() const {
    return {std::ldexp(centre.x.raw, -16), std::ldexp(centre.y.raw, -16), std::ldexp(centre.z.raw, -16)};
}

Position16 Lattice::nearest(const Double3& position) const {
    const Double3 offset = position - centre_value();
    const auto code = [&](double x) {
        return static_cast<int16_t>(std::clamp(std::round(std::ldexp(x, fraction_bits)), -largest_code, largest_code));
    };
    return {code(offset[0]), code(offset[1]), code(offset[2])};
}

Double3 Lattice::value(Position16 p) const {
    return centre_value() +
           Double3{std::ldexp(p.x, -fraction_bits), std::ldexp(p.y, -fraction_bits), std::ldexp(p.z, -fraction_bits)};
}

Lattice lattice_for(const std::vector<Double3>& positions) {
    const Box box = box_of(positions);
    Lattice about_origin{{}, most_fraction_bits};
    while (about_origin.fraction_bits > 0 && !holds(about_origin, box)) --about_origin.fraction_bits;
    if (is_exact(about_origin, positions)) return about_origin;

    for (int bits = most_fraction_bits; bits > 0; --bits)
        if (const Lattice lattice = about_middle(box, bits); holds(lattice, box)) return lattice;
    return about_middle(box, 0);
}

}  // namespace shade16::host
