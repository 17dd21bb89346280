#include "host_sim/model/quantize.hpp"

#include <random>

#include <gmock/gmock.h>
#include <meshoptimizer.h>

#include "host_sim/model/obj_import.hpp"
#include "host_sim/model/unit_normal.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;

BakedModel baked(const std::string& obj) {
    const ScratchDirectory scratch;
    return quantize(import_obj(scratch.write("a.obj", obj)));
}

BakedModel baked_teapot() { return quantize(import_obj((source_directory() / "assets/teapot.obj").string())); }

const std::string box =
    "v -1 -2 -3\nv 1 -2 -3\nv 1 2 -3\nv -1 2 -3\nv -1 -2 3\nv 1 -2 3\nv 1 2 3\nv -1 2 3\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(Quantize, an_exact_mesh_stays_exact_about_its_origin) {
    const BakedModel model = baked(box);
    EXPECT_EQ(model.centre, Vec3{});
    EXPECT_EQ(model.fraction_bits, 13);
    EXPECT_EQ(model.max_position_error, 0);
    EXPECT_TRUE(model.parts[0].convex);
    EXPECT_EQ(model.parts[0].flash_bytes(), 8u * 12 + 12u * 6);
}

TEST(Quantize, decimal_fractions_that_are_dyadic_are_exact) {
    const BakedModel model = baked("v 0.140625 0 0\nv 0 0.5 0\nv 0 0 -0.0009765625\nf 1 2 3\n");
    EXPECT_EQ(model.max_position_error, 0);
    EXPECT_EQ(model.centre, Vec3{});
}

TEST(Quantize, an_exact_mesh_far_from_its_origin_is_exact_about_its_middle) {
    const BakedModel model = baked("v 10000.25 0 0\nv 10001 0.25 0\nv 10000 0 0.125\nf 1 2 3\n");
    EXPECT_EQ(model.max_position_error, 0);
    EXPECT_NE(model.centre, Vec3{});
}

TEST(Quantize, rounds_to_half_a_step_at_most) {
    const BakedModel model = baked("v 0.1 0 0\nv 3.3 0.7 0\nv 0 -0.9 1.1\nf 1 2 3\n");
    EXPECT_EQ(model.fraction_bits, 14);  // 1.65 * 2^14 < 32767
    EXPECT_GT(model.max_position_error, 0);
    EXPECT_LE(model.max_position_error, std::sqrt(3.0) / 2 / 16384);
}

TEST(Quantize, covers_the_whole_domain_and_refuses_nothing_in_it) {
    const BakedModel model = baked("v 16384 16384 16384\nv -16384 16384 0.3\nv 0 -16384 -16384\nf 1 2 3\n");
    EXPECT_EQ(model.fraction_bits, 0);
    EXPECT_LE(model.max_position_error, 0.31);
}

TEST(Quantize, a_model_without_size_left_is_refused) {
    const std::string said =
        complaint([] { baked("v 100 0 0\nv 100.00000000001 0 0\nv 100 0.00000000001 0\nf 1 2 3\n"); });
    EXPECT_THAT(said, HasSubstr("2: a.obj: is so small that nothing is left after rounding"));
}

TEST(Quantize, triangles_that_lose_their_area_are_dropped_and_counted) {
    const BakedModel model = baked("v 0 0 0\nv 1000 0 0\nv 0 1000.3 0\nv 0.001 0.001 0\nf 1 2 3\nf 1 4 3\n");
    EXPECT_EQ(model.degenerate_triangles, 1u);
    EXPECT_EQ(model.triangle_count(), 1u);
    EXPECT_EQ(model.warnings.back(), "1 triangle lost all area by rounding to 16 bits and was dropped.");
}

TEST(Quantize, parts_share_the_lattice) {
    const BakedModel model =
        baked("v 0.1 0 0\nv 1.1 0.7 0\nv 0.3 1.2 5.4\nv 0 0 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\n");
    ASSERT_EQ(model.parts.size(), 1u);  // no library: both are the default material
    const BakedModel teapot = baked_teapot();
    const Mesh mesh = mesh_of(teapot, 0);
    EXPECT_EQ(mesh.centre, teapot.centre);
    EXPECT_EQ(mesh.fraction_bits, teapot.fraction_bits);
    EXPECT_EQ(mesh.positions.count, 529u);
    EXPECT_EQ(mesh.triangles.count, 992u);
    EXPECT_THROW(mesh_of(teapot, 1), std::out_of_range);
}

TEST(Quantize, too_many_vertices_are_refused) {
    std::string obj;
    for (int i = 0; i < 22000; ++i)
        obj += fmt::format("v {0} 0 0\nv {0} 1 0\nv {0} 0 1\nf -3 -2 -1\n", i % 16000 + (i / 16000) * 0.5);
    const std::string said = complaint([&] { baked(obj); });
    EXPECT_THAT(said, HasSubstr("2: a.obj: the part 'default' has 66000 different vertices; expected at most 65535, as "
                                "indices have 16 bits."));
}

TEST(Quantize, the_order_is_good_for_a_small_cache_and_always_the_same) {
    const BakedModel model = baked_teapot();
    std::vector<unsigned int> indices;
    for (const Triangle& t : model.parts[0].triangles) indices.insert(indices.end(), {t.a, t.b, t.c});
    const auto statistics = meshopt_analyzeVertexCache(indices.data(), indices.size(), 529, 16, 0, 0);
    EXPECT_LT(statistics.acmr, 0.75);  // misses a triangle; 3 is the worst, 0.53 has each vertex once
    EXPECT_EQ(indices[0] + indices[1] + indices[2], 3u) << "vertices are numbered as they are met";
    EXPECT_EQ(baked_teapot().parts[0].triangles, model.parts[0].triangles);
}

TEST(Quantize, colours_are_kept_per_vertex) {
    const BakedModel model = baked("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 2\nf 1 2 3\n");
    ASSERT_EQ(model.parts[0].colors.size(), 3u);
    EXPECT_EQ(model.parts[0].colors[0], (Rgb{{65535}, {0}, {0}}));
    EXPECT_EQ(model.parts[0].colors[1], (Rgb{{0}, {32768}, {0}}));
    EXPECT_EQ(model.parts[0].colors[2], (Rgb{{0}, {0}, {65535}}));
    EXPECT_EQ(model.flash_bytes(), 3u * 18 + 6);
}

TEST(UnitNormal, axes_are_exact) {
    EXPECT_EQ(nearest_normal({1, 0, 0}), (Normal14{{16384}, {0}, {0}}));
    EXPECT_EQ(nearest_normal({0, -1, 0}), (Normal14{{0}, {-16384}, {0}}));
}

TEST(UnitNormal, is_never_farther_in_direction_than_plain_rounding_and_a_step_off_in_length) {
    std::mt19937 random(1);
    std::normal_distribution<double> component;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Double3 unit = *direction({component(random), component(random), component(random)});
        const Normal14 normal = nearest_normal(unit);
        const auto plain = [&](std::size_t k) {
            return Unit14::from_raw(static_cast<int32_t>(std::lround(unit[k] * 16384)));
        };
        const double angle = angle_degrees(unit, normal);
        ASSERT_LE(angle, angle_degrees(unit, {plain(0), plain(1), plain(2)}));
        ASSERT_LE(std::fabs(std::sqrt(static_cast<double>(dot(normal, normal))) - 16384), 1);
        worst = std::max(worst, angle);
    }
    EXPECT_LT(worst, 0.0031);  // sqrt(3)/2 steps
}

}  // namespace
}  // namespace shade16::host
