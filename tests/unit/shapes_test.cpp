#include "shade16/scene/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace shade16 {
namespace {

struct Shape {
    const char* name;
    Mesh mesh;
};
const Shape shapes[] = {
    {"sphere<3, 2>", sphere<3, 2>.mesh()}, {"sphere<16, 12>", sphere<16, 12>.mesh()}, {"sphere<32, 24>", sphere<32, 24>.mesh()},
    {"torus<3, 3>", torus<3, 3>.mesh()},   {"torus<24, 12>", torus<24, 12>.mesh()},   {"cube", cube.mesh()},
    {"quad", quad.mesh()},
};

double dot_double(IVec3 a, IVec3 b) { return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z; }
IVec3 difference(Position16 a, Position16 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
// Within 2^33 as exact doubles, shortened by 2^8: only its direction is used.
IVec3 face_cross(IVec3 a, IVec3 b) {
    const auto minor = [](int64_t p, int64_t q, int64_t r, int64_t s) { return static_cast<int32_t>((p * q - r * s) / 256); };
    return {minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}

TEST(Shapes, NormalsAreOfUnitLength) {
    for (const Shape& shape : shapes) {
        ASSERT_EQ(shape.mesh.normals.count, shape.mesh.positions.count) << shape.name;
        for (const Normal14& n : shape.mesh.normals)
            ASSERT_LE(std::fabs(std::sqrt(dot_double(raw(n), raw(n))) / Unit14::one - 1), std::ldexp(1.0, -13)) << shape.name;
    }
}

// Each edge of a closed surface belongs to two faces, which run through it in opposite directions. Vertices of the cube
// are told apart by their positions, because each face has its own.
TEST(Shapes, SolidsAreClosed) {
    for (const Shape& shape : shapes) {
        if (shape.name == std::string("quad")) continue;
        using Point = std::tuple<int, int, int>;
        std::map<std::pair<Point, Point>, int> directed;
        for (const Triangle& t : shape.mesh.triangles) {
            const uint16_t corner[3] = {t.a, t.b, t.c};
            for (int i = 0; i < 3; ++i) {
                const Position16 p = shape.mesh.positions[corner[i]], q = shape.mesh.positions[corner[(i + 1) % 3]];
                ASSERT_NE(p, q) << shape.name;
                ++directed[{{p.x, p.y, p.z}, {q.x, q.y, q.z}}];
            }
        }
        for (const auto& [edge, count] : directed) {
            ASSERT_EQ(count, 1) << shape.name;
            const auto back = directed.find({edge.second, edge.first});
            ASSERT_TRUE(back != directed.end()) << shape.name;
        }
    }
}

TEST(Shapes, FacesRunCounterClockwiseSeenFromOutside) {
    for (const Shape& shape : shapes) {
        for (const Triangle& t : shape.mesh.triangles) {
            const auto& p = shape.mesh.positions;
            const IVec3 normal = face_cross(difference(p[t.b], p[t.a]), difference(p[t.c], p[t.a]));
            for (const uint16_t corner : {t.a, t.b, t.c}) ASSERT_GT(dot_double(normal, raw(shape.mesh.normals[corner])), 0) << shape.name;
        }
    }
}

TEST(Shapes, IndicesStayInsideTheMesh) {
    for (const Shape& shape : shapes)
        for (const Triangle& t : shape.mesh.triangles) {
            ASSERT_LT(t.a, shape.mesh.positions.count) << shape.name;
            ASSERT_LT(t.b, shape.mesh.positions.count) << shape.name;
            ASSERT_LT(t.c, shape.mesh.positions.count) << shape.name;
        }
}

// `convex` promises that a mesh drawn alone needs no depth buffer: no vertex may lie outside any face's plane.
TEST(Shapes, OnlyConvexMeshesAreFlaggedSo) {
    static_assert(cube.convex && quad.convex && !torus<12, 8>.convex);
    for (const Shape& shape : shapes) {
        if (!shape.mesh.convex) continue;
        for (const Triangle& t : shape.mesh.triangles) {
            const auto& p = shape.mesh.positions;
            const IVec3 normal = face_cross(difference(p[t.b], p[t.a]), difference(p[t.c], p[t.a]));
            for (const Position16& q : p) ASSERT_LE(dot_double(normal, difference(q, p[t.a])), 0) << shape.name;
        }
    }
}

TEST(Shapes, HaveTheSizesTheyAreDocumentedWith) {
    for (const Position16& p : sphere<32, 24>.positions) ASSERT_NEAR(std::sqrt(dot_double(raw(p), raw(p))), 16384, 1);
    for (const Position16& p : torus<24, 12>.positions) {
        const double ring = std::hypot(double(p.x), double(p.y)) / 8192 - 1;
        ASSERT_NEAR(std::hypot(ring, p.z / 8192.0), 0.4, 2.0 / 8192);
    }
    for (const Position16& p : cube.positions) ASSERT_TRUE(std::abs(p.x) == 16384 && std::abs(p.y) == 16384 && std::abs(p.z) == 16384);
    static_assert(sphere<32, 24>.fraction_bits == 14 && torus<24, 12>.fraction_bits == 13 && cube.fraction_bits == 14);
}

}  // namespace
}  // namespace shade16
