// The tiers' promises, against the double-precision reference on the same integers: searched for with restarts, since
// uniformly drawn vertices miss the worst cases.
#include <cstdio>

#include <gtest/gtest.h>

#include "accuracy/random_surface.hpp"

namespace shade16::host {
namespace {

struct Worst {
    double error = 0, share_of_bound = 0;
    std::size_t vertices = 0, beside_gate = 0;

    void add(const Verdict& v) {
        error = std::max(error, v.error_levels);
        share_of_bound = std::max(share_of_bound, v.error_levels / v.bound_levels);
        ++vertices;
        beside_gate += v.beside_gate;
    }
};

template <class Tier>
class Promises : public testing::Test {
protected:
    static constexpr int bits = ScreenVertex<Tier>::channel_bits;

    static Verdict judge_vertex(RuntimeRenderer<Tier>& renderer, const reference::Scene& exact, uint32_t i) {
        const auto v = renderer.lit_vertex(0, i);
        const glm::dvec3 color = glm::dvec3(v.r, v.g, v.b) * std::ldexp(1.0, -bits);
        return judge(color, reference::light_vertex(exact, {}, 0, i), exact.values.objects[0].material, promised<Tier>(bits));
    }

    static std::vector<Verdict> judge_all(const RandomSurface& surface, Worst& worst) {
        RuntimeRenderer<Tier> renderer(surface.scene());
        renderer.begin({}, {64, 64});
        const reference::Scene exact = reference::value(surface.scene());
        std::vector<Verdict> verdicts;
        for (uint32_t i = 0; i < RandomSurface::vertex_count; ++i) {
            verdicts.push_back(judge_vertex(renderer, exact, i));
            worst.add(verdicts.back());
        }
        return verdicts;
    }

    /// Random restarts; from each, the worse half of the vertices stays and the better half moves beside them.
    static Worst search(uint64_t seed, const SurfaceOptions& options, int restarts, int steps) {
        Random random(seed);
        Worst worst;
        for (int restart = 0; restart < restarts; ++restart) {
            RandomSurface surface(random, options);
            for (int step = 0; step < steps; ++step) climb(surface, judge_all(surface, worst), random);
        }
        return worst;
    }

    static void climb(RandomSurface& surface, const std::vector<Verdict>& verdicts, Random& random) {
        std::vector<uint32_t> order(verdicts.size());
        for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            return verdicts[a].error_levels / verdicts[a].bound_levels > verdicts[b].error_levels / verdicts[b].bound_levels;
        });
        const std::size_t half = order.size() / 2;
        for (std::size_t k = 0; k < half; ++k) {
            const uint32_t from = order[k / 4], to = order[half + k];
            const int reach = 1 << random.integer(0, 10);
            const auto moved = [&](int16_t v) { return static_cast<int16_t>(std::clamp(v + random.integer(-reach, reach), -32767, 32767)); };
            const Position16 p = surface.position(from);
            surface.position(to) = {moved(p.x), moved(p.y), moved(p.z)};
            const Normal14 n = surface.normal(from);
            surface.normal(to) = normal14({n.x.raw + random.integer(-reach, reach), n.y.raw + random.integer(-reach, reach), n.z.raw + random.integer(-reach, reach)});
        }
    }

    static void expect_held(const Worst& worst, const char* domain) {
        EXPECT_LE(worst.share_of_bound, 1.0);
        EXPECT_GT(worst.error, 0.0) << "the reference never differs: it is no reference";
        testing::Test::RecordProperty("worst_error_micro_levels", static_cast<int>(worst.error * 1e6));
        std::printf("[ %-7s  ] %-28s worst %.4f levels, %.3f of its bound, %zu vertices, %.3f %% beside a gate\n", Tier::name, domain,
                    worst.error, worst.share_of_bound, worst.vertices, 100.0 * static_cast<double>(worst.beside_gate) / static_cast<double>(worst.vertices));
    }
};

using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Promises, Tiers);

TYPED_TEST(Promises, HoldForExponentsTo128) {
    this->expect_held(this->search(1, {}, 400, 12), "one light, n <= 128");
}
TYPED_TEST(Promises, HoldForExponentsTo1000) {
    this->expect_held(this->search(2, {.min_exponent = 128, .max_exponent = 1000}, 400, 12), "one light, n <= 1000");
}
TYPED_TEST(Promises, HoldForTheSumOfSeveralLights) {
    this->expect_held(this->search(3, {.lights = 4}, 60, 6), "four lights and ambient");
}
TYPED_TEST(Promises, HoldUnderAScaleThatDiffersByAxis) {
    this->expect_held(this->search(4, {.stretch = true}, 60, 8), "stretched, n <= 128");
}
TYPED_TEST(Promises, HoldForLampsFarAway) {
    this->expect_held(this->search(5, {.max_distance = 16000}, 60, 6), "lamps and eye far away");
}

TYPED_TEST(Promises, HoldForLampsThatFadeWithDistance) {
    this->expect_held(this->search(8, {.attenuation = true}, 100, 8), "attenuation, n <= 128");
}

TYPED_TEST(Promises, HoldForPhongReflectionTo128) {
    this->expect_held(this->search(9, {.reflected = true}, 200, 12), "Phong reflection, n <= 128");
}
TYPED_TEST(Promises, HoldForPhongReflectionTo1000) {
    this->expect_held(this->search(10, {.min_exponent = 128, .max_exponent = 1000, .reflected = true}, 200, 12), "Phong reflection, n <= 1000");
}
TYPED_TEST(Promises, HoldForLampsThatFallOff) {
    this->expect_held(this->search(11, {.falloff = true}, 100, 8), "falloff 1/d^p");
}
TYPED_TEST(Promises, HoldForLampsThatEnd) {
    this->expect_held(this->search(12, {.range = true}, 100, 8), "range");
}
TYPED_TEST(Promises, HoldForSpots) {
    // The narrowest penumbra of which the promise is made: docs/DESIGN.md.
    const double narrowest = Arithmetic<TypeParam>::wide ? 1 : 0.1;
    this->expect_held(this->search(13, {.min_cone_degrees = narrowest}, 600, 12), "spots");
}
TYPED_TEST(Promises, HoldForSpotsWithAllTheRest) {
    this->expect_held(this->search(14, {.lights = 3, .stretch = true, .attenuation = true, .reflected = true, .falloff = true, .range = true, .min_cone_degrees = 1}, 100, 8),
                      "spots, range, falloff, all");
}

// A fourth tier, as a user may write it: the code sizes itself from the promise.
struct fine {
    static constexpr const char* name = "fine";
    static constexpr Promise promise{0.3_levels, 1_levels};
    static constexpr Stepping stepping = Stepping::exact;
};
template <class Tier>
class UserTier : public Promises<Tier> {};
TYPED_TEST_SUITE(UserTier, testing::Types<fine>);

TYPED_TEST(UserTier, HoldsItsPromise) {
    this->expect_held(this->search(6, {}, 30, 8), "a user's tier, n <= 128");
    this->expect_held(this->search(7, {.min_exponent = 128, .max_exponent = 1000}, 30, 8), "a user's tier, n <= 1000");
}

}  // namespace
}  // namespace shade16::host
