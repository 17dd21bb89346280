#include "host_sim/model/unit_normal.hpp"

#include <limits>

namespace shade16::host {

namespace {

Double3 steps(Normal14 n) { return {double(n.x.raw), double(n.y.raw), double(n.z.raw)}; }

}  // namespace

Normal14 nearest_normal(const Double3& unit) {
    const Double3 exact = unit * Unit14::one;
    Normal14 best{};
    double least_turn = std::numeric_limits<double>::infinity();
    for (unsigned int choice = 0; choice < 8; ++choice) {
        const auto component = [&](unsigned int i) {
            const double rounded = (choice >> i & 1u) != 0 ? std::ceil(exact[i]) : std::floor(exact[i]);
            return Unit14::from_raw(static_cast<int32_t>(rounded));
        };
        const Normal14 candidate{component(0), component(1), component(2)};
        if (std::fabs(length(steps(candidate)) - Unit14::one) > 1) continue;
        const double turn = angle_degrees(unit, candidate);
        if (turn >= least_turn) continue;
        least_turn = turn;
        best = candidate;
    }
    return best;
}

double angle_degrees(const Double3& unit, Normal14 normal) {
    constexpr double degrees = 180 / 3.14159265358979323846;
    return std::atan2(length(cross(unit, steps(normal))), dot(unit, steps(normal))) * degrees;
}

}  // namespace shade16::host
