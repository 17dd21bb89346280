// The verdict on one lit point: how far it is from the reference, and how far the tier's promise lets it be.
#pragma once

#include <glm/glm.hpp>

#include "host_sim/reference/light.hpp"
#include "shade16/num/tier.hpp"

namespace shade16::host {

inline constexpr double levels_of_full_scale = 255;

struct Verdict {
    double error_levels = 0;      // of the worst channel
    double bound_levels = 0;
    bool beside_gate = false;     // either side of a light's step at N.L = 0 was accepted
    glm::dvec3 reference{};       // the accepted reference colour, saturated

    bool holds() const { return error_levels <= bound_levels; }
};

/// What a tier promises, as doubles.
struct PromisedLevels {
    double to_exponent_128 = 0, to_exponent_1000 = 0;
    double gate = 0;       // |N.L| below which either side of the step counts
    double rounding = 0;   // of the stored channel, half a unit, in levels
};

template <PrecisionTier Tier>
PromisedLevels promised(int channel_bits) {
    return {Tier::promise.to_exponent_128.micro / 1e6, Tier::promise.to_exponent_1000.micro / 1e6,
            std::ldexp(1.0, Arithmetic<Tier>::gate_log2), levels_of_full_scale * std::ldexp(0.5, -channel_bits)};
}

/// Judges a colour in [0, 1] against the reference's parts of the same point.
Verdict judge(const glm::dvec3& color, const reference::LightParts& parts, const Material& material, const PromisedLevels& promise);

}  // namespace shade16::host
