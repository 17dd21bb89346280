// Whole vertices against double precision: searched with restarts for the worst case of each tier, since uniformly
// drawn vertices miss it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host_sim/bounds/random_surface.hpp"
#include "host_sim/bounds/result.hpp"

namespace shade16::bounds {

/// A kind of scene, and how long it is searched.
struct VertexDomain {
    const char* name;
    const char* functions;  // which terms of the light it is about
    uint64_t seed;
    host::SurfaceOptions options;
    int restarts, steps;
};

/// All of them; cones are as narrow as the tier promises.
std::vector<VertexDomain> vertex_domains(bool wide_tier);

/// What a search found. Errors are in levels.
class VertexFigures {
public:
    static constexpr std::size_t bins = 40;  // of the share of the bound, from 0 to 1 and beyond

    void add(const host::Verdict& verdict, const glm::dvec3& color);

    double largest_levels() const { return largest_; }
    double largest_share() const { return share_; }
    double mean_levels() const { return sum_ / static_cast<double>(errors_.size()); }
    /// The error that 99.9 % of the vertices keep below.
    double usual_levels() const;
    /// The share of channels that round to the reference's 8-bit code, and to its RGB565 code.
    double exact_at_8_bits() const { return static_cast<double>(exact_8_) / static_cast<double>(3 * errors_.size()); }
    double exact_at_565() const { return static_cast<double>(exact_565_) / static_cast<double>(3 * errors_.size()); }
    double beside_gate() const { return static_cast<double>(beside_gate_) / static_cast<double>(errors_.size()); }
    uint64_t vertices() const { return errors_.size(); }
    const std::array<uint64_t, bins + 1>& histogram() const { return histogram_; }
    void add(const VertexFigures& other);

private:
    double largest_ = 0, share_ = 0, sum_ = 0;
    uint64_t exact_8_ = 0, exact_565_ = 0, beside_gate_ = 0;
    std::vector<float> errors_{};
    std::array<uint64_t, bins + 1> histogram_{};
};

/// Random restarts; from each, the worse half of the vertices stays and the better half moves beside them.
template <PrecisionTier Tier>
VertexFigures search(const VertexDomain& domain);

extern template VertexFigures search<lowp>(const VertexDomain&);
extern template VertexFigures search<mediump>(const VertexDomain&);
extern template VertexFigures search<highp>(const VertexDomain&);

struct VertexResult {
    const char* tier;
    VertexDomain domain;
    VertexFigures figures{};

    Result result() const;
};

/// Every domain in every tier whose label begins with `only`; `thoroughness` times as many restarts, from seeds so much
/// larger. `done` is told each.
std::vector<VertexResult> search_all(const std::string& only, int thoroughness, uint64_t seed,
                                     const std::function<void(const VertexResult&)>& done);

}  // namespace shade16::bounds
