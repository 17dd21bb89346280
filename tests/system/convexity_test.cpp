#include "host_sim/model/convexity.hpp"

#include <gtest/gtest.h>

#include "shade16/scene/shapes.hpp"

namespace shade16::host {
namespace {

bool mesh_is_convex(const Mesh& mesh) {
    return is_convex(std::span(mesh.positions.begin(), mesh.positions.end()),
                     std::span(mesh.triangles.begin(), mesh.triangles.end()));
}

const std::vector<Position16> tetrahedron{{0, 0, 0}, {32767, 0, 0}, {0, 32767, 0}, {0, 0, 32767}};
const std::vector<Triangle> outwards{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

TEST(Convexity, a_tetrahedron_is_convex) { EXPECT_TRUE(is_convex(tetrahedron, outwards)); }

TEST(Convexity, inside_out_is_not) {
    const std::vector<Triangle> inwards{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    EXPECT_FALSE(is_convex(tetrahedron, inwards));
}

TEST(Convexity, one_face_turned_round_is_not) {
    std::vector<Triangle> mixed = outwards;
    mixed[3] = {1, 3, 2};
    EXPECT_FALSE(is_convex(tetrahedron, mixed));
}

TEST(Convexity, an_open_mesh_is_not) {
    EXPECT_FALSE(is_convex(tetrahedron, std::vector<Triangle>(outwards.begin(), outwards.end() - 1)));
    EXPECT_FALSE(mesh_is_convex(quad.mesh()));
    EXPECT_FALSE(is_convex(tetrahedron, {}));
}

TEST(Convexity, faces_of_one_plane_and_vertices_of_one_position_are_allowed) {
    EXPECT_TRUE(mesh_is_convex(cube.mesh()));
}

TEST(Convexity, the_largest_cube_does_not_overflow) {
    std::vector<Position16> corners;
    for (const Position16& p : cube.positions) {
        const auto far = [](int16_t x) { return x < 0 ? int16_t{-32768} : int16_t{32767}; };
        corners.push_back({far(p.x), far(p.y), far(p.z)});
    }
    EXPECT_TRUE(is_convex(corners, cube.triangles));
    corners[0].x = static_cast<int16_t>(corners[0].x - (corners[0].x > 0 ? 1 : -1));
    EXPECT_FALSE(is_convex(corners, cube.triangles)) << "one corner is a step further in on one face: the seam is open";
}

TEST(Convexity, a_dent_of_one_step_is_seen) {
    // Two tetrahedra base to base; the shared edge 1-2 then lies one step inside of the plane of the others.
    std::vector<Position16> p{{0, 0, 10}, {10, 0, 0}, {0, 10, 0}, {-10, 0, 0}, {0, -10, 0}, {0, 0, -10}};
    const std::vector<Triangle> octahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                           {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
    EXPECT_TRUE(is_convex(p, octahedron));
    p[1].x = -1;
    EXPECT_FALSE(is_convex(p, octahedron));
}

TEST(Convexity, a_rounded_sphere_is_not_convex) { EXPECT_FALSE(mesh_is_convex(sphere<32, 16>.mesh())); }

TEST(Convexity, a_torus_is_not_convex) { EXPECT_FALSE(mesh_is_convex(torus<24, 12>.mesh())); }

}  // namespace
}  // namespace shade16::host
