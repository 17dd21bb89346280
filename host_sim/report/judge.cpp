#include "host_sim/report/judge.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shade16::host {

namespace {
double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return levels_of_full_scale * std::max({d.x, d.y, d.z});
}

/// promise * sum of what arrives, each light by its own condition |L + V| >= 0.5, plus one rounding.
double bound(const reference::LightParts& parts, const Material& material, const PromisedLevels& promise) {
    const double each = reference::value(material.shininess) <= 128 ? promise.to_exponent_128 : promise.to_exponent_1000;
    double sum = promise.rounding + 1e-4;  // 1e-4: a few units of 2^-24 from the accumulator
    for (const reference::LightShare& share : parts.shares) sum += each * share.arriving * std::max(1.0, 0.5 / std::max(share.half_length, 1e-9));
    return sum;
}
}  // namespace

Verdict judge(const glm::dvec3& color, const reference::LightParts& parts, const Material& material, const PromisedLevels& promise) {
    glm::dvec3 diffuse = parts.base, specular(0);
    std::vector<glm::dvec3> beside;  // specular parts that may count or not
    for (const reference::LightShare& share : parts.shares) {
        diffuse += share.diffuse;
        if (std::abs(share.n_dot_l) < promise.gate && beside.size() < 4) beside.push_back(share.specular);
        else if (share.n_dot_l > 0) specular += share.specular;
    }
    Verdict best{1e9, bound(parts, material, promise), !beside.empty(), {}};
    for (unsigned open = 0; open < (1u << beside.size()); ++open) {
        glm::dvec3 sum = parts.color * diffuse + specular;
        for (std::size_t i = 0; i < beside.size(); ++i)
            if (open >> i & 1) sum += beside[i];
        const glm::dvec3 reference = glm::clamp(sum, 0.0, 1.0);
        if (const double error = largest_difference(color, reference); error < best.error_levels) {
            best.error_levels = error;
            best.reference = reference;
        }
    }
    return best;
}

}  // namespace shade16::host
