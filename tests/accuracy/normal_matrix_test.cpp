// Normals go by the inverse transpose. Under a scale that differs by axis the engine keeps its promise against a reference that
// does so, and breaks it against one that takes normals through the plain matrix: the promise can tell them apart.
#include <gtest/gtest.h>

#include "host_sim/bounds/random_surface.hpp"

namespace shade16::host {
namespace {

template <class Tier>
class NormalMatrix : public testing::Test {};
using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(NormalMatrix, Tiers);

/// The reference's light at a vertex, its normal taken to the world by rotation * scale.
reference::LightParts lit_by_plain_matrix(const reference::Scene& scene, uint32_t vertex) {
    const reference::FrameValues values(scene.values, {});
    const Object& object = scene.values.objects[0];
    const reference::Mesh& mesh = scene.meshes[0];
    const glm::dvec3 normal = reference::value(object.pose.rotation) * (reference::value(object.pose.scale) * mesh.normals[vertex]);
    return reference::light_point(values.camera, values.lights, object.material, object.pose,
                                  {reference::to_world(object.pose, mesh.positions[vertex]), glm::normalize(normal), glm::dvec3(1)});
}

TYPED_TEST(NormalMatrix, IsTheInverseTranspose) {
    constexpr int bits = ScreenVertex<TypeParam>::channel_bits;
    Random random(21);
    std::size_t vertices = 0, broken = 0;
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
        RandomSurface surface(random, {.stretch = true, .max_distance = 20});
        RuntimeRenderer<TypeParam> renderer(surface.scene());
        renderer.begin({}, {64, 64});
        const reference::Scene exact = reference::value(surface.scene());
        for (uint32_t v = 0; v < RandomSurface::vertex_count; ++v) {
            const auto lit = renderer.lit_vertex(0, v);
            const glm::dvec3 color = glm::dvec3(lit.r, lit.g, lit.b) * std::ldexp(1.0, -bits);
            const auto verdict = [&](const reference::LightParts& parts) { return judge(color, parts, exact.values.objects[0].material, promised<TypeParam>(bits)); };
            ASSERT_TRUE(verdict(reference::light_vertex(exact, {}, 0, v)).holds());
            const Verdict plain = verdict(lit_by_plain_matrix(exact, v));
            worst = std::max(worst, plain.error_levels);
            ++vertices;
            broken += !plain.holds();
        }
    }
    EXPECT_GT(broken, vertices / 4) << "of " << vertices;
    EXPECT_GT(worst, 100) << "levels";
    testing::Test::RecordProperty("broken_by_the_plain_matrix_percent", static_cast<int>(100 * broken / vertices));
}

// At a uniform scale both are the same matrix up to a factor, so that nothing above comes from elsewhere.
TYPED_TEST(NormalMatrix, IsThePlainOneAtAUniformScale) {
    Random random(22);
    RandomSurface surface(random, {});
    const reference::Scene exact = reference::value(surface.scene());
    for (uint32_t v = 0; v < RandomSurface::vertex_count; ++v) {
        const glm::dvec3 difference = lit_by_plain_matrix(exact, v).sum() - reference::light_vertex(exact, {}, 0, v).sum();
        EXPECT_LT(glm::length(difference), 1e-9);
    }
}

}  // namespace
}  // namespace shade16::host
