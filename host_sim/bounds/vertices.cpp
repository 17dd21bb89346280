#include "host_sim/bounds/vertices.hpp"

#include <cmath>

namespace shade16::bounds {

std::vector<VertexDomain> vertex_domains(bool wide_tier) {
    const double narrowest =
        wide_tier ? 1 : 0.1;  // degrees between a cone's angles, of which the promise is made: docs/DESIGN.md
    return {
        {"one light, n <= 128", "diffuse specular directional point", 1, {}, 400, 12},
        {"one light, n <= 1000", "specular", 2, {.min_exponent = 128, .max_exponent = 1000}, 400, 12},
        {"four lights, ambient and emission", "ambient emissive", 3, {.lights = 4}, 60, 6},
        {"scale that differs by axis", "stretch", 4, {.stretch = true}, 60, 8},
        {"lamps and eye far away", "local_viewer", 5, {.max_distance = 16000}, 60, 6},
        {"attenuation", "attenuation", 8, {.attenuation = true}, 100, 8},
        {"Phong reflection, n <= 128", "reflected", 9, {.reflected = true}, 200, 12},
        {"Phong reflection, n <= 1000",
         "reflected",
         10,
         {.min_exponent = 128, .max_exponent = 1000, .reflected = true},
         200,
         12},
        {"falloff 1/d^p", "falloff", 11, {.falloff = true}, 100, 8},
        {"range", "range", 12, {.range = true}, 100, 8},
        {"spots", "spot spot_exponent", 13, {.min_cone_degrees = narrowest}, 600, 12},
        {"spots with all the rest",
         "spot range falloff attenuation reflected",
         14,
         {.lights = 3,
          .stretch = true,
          .attenuation = true,
          .reflected = true,
          .falloff = true,
          .range = true,
          .min_cone_degrees = 1},
         100,
         8},
    };
}

void VertexFigures::add(const host::Verdict& v, const glm::dvec3& color) {
    largest_ = std::max(largest_, v.error_levels);
    const double share = v.error_levels / v.bound_levels;
    share_ = std::max(share_, share);
    sum_ += v.error_levels;
    errors_.push_back(static_cast<float>(v.error_levels));
    beside_gate_ += v.beside_gate;
    ++histogram_[std::min(static_cast<std::size_t>(share * bins), bins)];
    for (int i = 0; i < 3; ++i) {
        const double codes = i == 1 ? 63 : 31;
        exact_8_ += std::round(255 * color[i]) == std::round(255 * v.reference[i]);
        exact_565_ += std::round(codes * color[i]) == std::round(codes * v.reference[i]);
    }
}

void VertexFigures::add(const VertexFigures& other) {
    largest_ = std::max(largest_, other.largest_), share_ = std::max(share_, other.share_), sum_ += other.sum_;
    exact_8_ += other.exact_8_, exact_565_ += other.exact_565_, beside_gate_ += other.beside_gate_;
    errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end());
    for (std::size_t i = 0; i <= bins; ++i) histogram_[i] += other.histogram_[i];
}

double VertexFigures::usual_levels() const {
    std::vector<float> sorted = errors_;
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 999 / 1000);
    std::nth_element(sorted.begin(), place, sorted.end());
    return static_cast<double>(*place);
}

Result VertexResult::result() const {
    return {.name = std::string("vertex: ") + domain.name,
            .header = "pipeline/light.hpp",
            .functions = domain.functions,
            .unit = "of its promise",
            .tier = tier,
            .bound = 1,
            .measured = figures.largest_share(),
            .inputs = figures.vertices()};
}

std::vector<VertexResult> search_all(const std::string& only, int thoroughness, uint64_t seed,
                                     const std::function<void(const VertexResult&)>& done) {
    std::vector<VertexResult> results;
    const auto search_tier = [&]<PrecisionTier Tier>(Tier) {
        for (VertexDomain domain : vertex_domains(Arithmetic<Tier>::wide)) {
            VertexResult found{Tier::name, domain};
            if (const Result r = found.result(); !label(r.name, r.tier).starts_with(only)) continue;
            domain.restarts *= thoroughness, domain.seed += seed;
            found.figures = search<Tier>(domain);
            if (done) done(found);
            results.push_back(std::move(found));
        }
    };
    search_tier(lowp{}), search_tier(mediump{}), search_tier(highp{});
    return results;
}

}  // namespace shade16::bounds
