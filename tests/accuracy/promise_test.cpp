// The tiers' promises, against the double-precision reference on the same integers: searched for with restarts, since
// uniformly drawn vertices miss the worst cases. `shade16 report bounds` searches the engine's own tiers ten times as
// long, and refuses what is broken; here they are searched under sanitizers, and a user's tier is held to its promise.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "host_sim/bounds/vertex_search.hpp"
#include "host_sim/report/terms.hpp"

namespace shade16::bounds {
namespace {

void expect_held(const VertexFigures& found, const char* tier, const char* domain) {
    EXPECT_LE(found.largest_share(), 1.0) << tier << ", " << domain;
    EXPECT_GT(found.largest_levels(), 0.0) << "the reference never differs: it is no reference";
    std::printf("[ %-7s  ] %-28s worst %.4f levels, %.3f of its bound, %zu vertices, %.3f %% beside a gate\n", tier,
                domain, found.largest_levels(), found.largest_share(), static_cast<std::size_t>(found.vertices()),
                100.0 * found.beside_gate());
}

template <class Tier>
class Promises : public testing::Test {};
using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Promises, Tiers);

TYPED_TEST(Promises, HoldInEveryDomain) {
    for (VertexDomain domain : vertex_domains(Arithmetic<TypeParam>::wide)) {
        domain.restarts /= 10;
        expect_held(search<TypeParam>(domain), TypeParam::name, domain.name);
    }
}

// Each term of the light is in some kind of scene that is searched.
TEST(VertexDomains, HoldEveryTermOfTheLight) {
    Needs seen;
    for (const VertexDomain& domain : vertex_domains(true)) {
        host::Random random(domain.seed);
        for (int i = 0; i < 20; ++i) seen = seen | needs_of(host::RandomSurface(random, domain.options).scene());
    }
    constexpr bool Needs::*light[] = {
        &Needs::ambient,     &Needs::diffuse,       &Needs::specular,     &Needs::halfway, &Needs::reflected,
        &Needs::directional, &Needs::point,         &Needs::attenuation,  &Needs::falloff, &Needs::range,
        &Needs::spot,        &Needs::spot_exponent, &Needs::local_viewer, &Needs::stretch};
    for (const host::Term& term : host::terms) {
        if (std::ranges::find(light, term.is_needed) == std::end(light)) continue;
        EXPECT_TRUE(seen.*term.is_needed) << term.name;
    }
}

// A fourth tier, as a user may write it: the code sizes itself from the promise.
struct fine {
    static constexpr const char* name = "fine";
    static constexpr Promise promise{0.3_levels, 1_levels};
    static constexpr Stepping stepping = Stepping::exact;
};

TEST(UserTier, HoldsItsPromise) {
    for (VertexDomain domain : vertex_domains(Arithmetic<fine>::wide)) {
        domain.restarts /= 10;
        expect_held(search<fine>(domain), fine::name, domain.name);
    }
}

}  // namespace
}  // namespace shade16::bounds
