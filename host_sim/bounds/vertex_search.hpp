// The search itself, for the tiers of the engine and for a user's own.
#pragma once

#include "host_sim/bounds/vertices.hpp"
#include "host_sim/engine/runtime_renderer.hpp"

namespace shade16::bounds {

template <PrecisionTier Tier>
class VertexSearch {
public:
    explicit VertexSearch(const VertexDomain& domain) : domain_(domain), random_(domain.seed) {}

    VertexFigures run() {
        for (int restart = 0; restart < domain_.restarts; ++restart) {
            host::RandomSurface surface(random_, domain_.options);
            for (int step = 0; step < domain_.steps; ++step) climb(surface, judge_all(surface));
        }
        return figures_;
    }

private:
    static constexpr int bits = ScreenVertex<Tier>::channel_bits;

    std::vector<double> judge_all(const host::RandomSurface& surface) {
        host::RuntimeRenderer<Tier> renderer(surface.scene());
        renderer.begin({}, {64, 64});
        const reference::Scene exact = reference::value(surface.scene());
        std::vector<double> shares;
        for (uint32_t i = 0; i < host::RandomSurface::vertex_count; ++i) {
            const auto v = renderer.lit_vertex(0, i);
            const glm::dvec3 color = glm::dvec3(v.r, v.g, v.b) * std::ldexp(1.0, -bits);
            const host::Verdict verdict = host::judge(color, reference::light_vertex(exact, {}, 0, i),
                                                      exact.values.objects[0].material, host::promised<Tier>(bits));
            figures_.add(verdict, color);
            shares.push_back(verdict.error_levels / verdict.bound_levels);
        }
        return shares;
    }

    void climb(host::RandomSurface& surface, const std::vector<double>& shares) {
        std::vector<uint32_t> order(shares.size());
        for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return shares[a] > shares[b]; });
        const std::size_t half = order.size() / 2;
        for (std::size_t k = 0; k < half; ++k) {
            const uint32_t from = order[k / 4], to = order[half + k];
            const int reach = 1 << random_.integer(0, 10);
            const auto moved = [&](int16_t v) {
                return static_cast<int16_t>(std::clamp(v + random_.integer(-reach, reach), -32767, 32767));
            };
            const Position16 p = surface.position(from);
            surface.position(to) = {moved(p.x), moved(p.y), moved(p.z)};
            const Normal14 n = surface.normal(from);
            surface.normal(to) =
                host::normal14({n.x.raw + random_.integer(-reach, reach), n.y.raw + random_.integer(-reach, reach),
                                n.z.raw + random_.integer(-reach, reach)});
        }
    }

    VertexDomain domain_;
    host::Random random_;
    VertexFigures figures_{};
};

template <PrecisionTier Tier>
VertexFigures search(const VertexDomain& domain) {
    return VertexSearch<Tier>(domain).run();
}

}  // namespace shade16::bounds
