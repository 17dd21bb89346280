// Built-in shapes, made by the compiler: sphere, torus, cube, quad. They need no file and no licence. The functions that
// fill arrays also run: a simulator makes at run time the very mesh that an image has in flash.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/normalize.hpp"
#include "shade16/scene/mesh.hpp"

namespace shade16 {

/// The arrays behind a Mesh. Give it static storage (the shapes below have it) and pass `mesh()` to an Object.
template <uint32_t Vertices, uint32_t Triangles>
struct MeshData {
    Position16 positions[Vertices]{};
    Normal14 normals[Vertices]{};
    Triangle triangles[Triangles]{};
    int8_t fraction_bits = 14;
    bool convex = false;

    constexpr Mesh mesh() const {
        return {.positions = positions, .normals = normals, .triangles = triangles, .fraction_bits = fraction_bits, .convex = convex};
    }
};

inline constexpr int32_t torus_minor_radius = 429'496'730;  // Q30: 0.4

namespace detail {
inline constexpr int8_t torus_fraction_bits = 13;  // it reaches 2

/// A Q30 number at `bits` fraction bits.
constexpr int32_t narrowed(Q30 v, int bits) { return shift_right_round(v.raw, 30 - bits); }
constexpr Q30 product(Q30 a, Q30 b) { return Q30::from_raw(shift_right_round(multiply(a.raw, b.raw), 30)); }
constexpr Normal14 narrowed(const Normal30& v) {
    return {Unit14::from_raw(narrowed(v.x, 14)), Unit14::from_raw(narrowed(v.y, 14)), Unit14::from_raw(narrowed(v.z, 14))};
}
/// i / n of a turn.
constexpr Angle fraction_of_turn(uint32_t i, uint32_t n) {
    return {static_cast<uint32_t>(((uint64_t{i} << 32) + n / 2) / n)};
}
constexpr uint16_t index16(uint32_t i) { return static_cast<uint16_t>(i); }

/// Where a shape is put: the arrays of a MeshData, or whatever has as many elements.
struct ShapeArrays {
    Position16* positions;
    Normal14* normals;
    Triangle* triangles;
};

constexpr uint32_t sphere_vertices(uint32_t slices, uint32_t stacks) { return slices * (stacks - 1) + 2; }
constexpr uint32_t sphere_triangles(uint32_t slices, uint32_t stacks) { return 2 * slices * (stacks - 1); }

constexpr void fill_sphere(const ShapeArrays& s, uint32_t slices, uint32_t stacks) {
    uint32_t vertex = 0, triangle = 0;
    const auto add = [&](Normal30 unit) {
        s.positions[vertex] = {static_cast<int16_t>(narrowed(unit.x, 14)), static_cast<int16_t>(narrowed(unit.y, 14)), static_cast<int16_t>(narrowed(unit.z, 14))};
        s.normals[vertex++] = narrowed(unit);
    };
    add({{}, {Q30::one}, {}});
    for (uint32_t i = 1; i < stacks; ++i) {
        const auto [sin_t, cos_t] = sincos(fraction_of_turn(i, 2 * stacks));
        for (uint32_t j = 0; j < slices; ++j) {
            const auto [sin_p, cos_p] = sincos(fraction_of_turn(j, slices));
            add({product(sin_t, sin_p), cos_t, product(sin_t, cos_p)});
        }
    }
    add({{}, {-Q30::one}, {}});
    const auto ring = [=](uint32_t i, uint32_t j) { return index16(1 + (i - 1) * slices + j % slices); };
    for (uint32_t j = 0; j < slices; ++j) {
        s.triangles[triangle++] = {0, ring(1, j), ring(1, j + 1)};
        for (uint32_t i = 1; i + 1 < stacks; ++i) {
            s.triangles[triangle++] = {ring(i, j), ring(i + 1, j), ring(i + 1, j + 1)};
            s.triangles[triangle++] = {ring(i, j), ring(i + 1, j + 1), ring(i, j + 1)};
        }
        s.triangles[triangle++] = {ring(stacks - 1, j), index16(vertex - 1), ring(stacks - 1, j + 1)};
    }
}

template <uint32_t Slices, uint32_t Stacks>
consteval auto make_sphere() {
    static_assert(Slices >= 3 && Stacks >= 2, "a sphere has at least 3 slices and 2 stacks");
    MeshData<sphere_vertices(Slices, Stacks), sphere_triangles(Slices, Stacks)> s;
    fill_sphere({s.positions, s.normals, s.triangles}, Slices, Stacks);
    return s;
}

constexpr void torus_vertex(Position16& position, Normal14& normal, Angle along, Angle around, Q30 minor) {
    const auto [sin_u, cos_u] = sincos(along);
    const auto [sin_v, cos_v] = sincos(around);
    const Q30 radius{shift_right_round(Q30::one + product(minor, cos_v).raw, 1)};  // halved: it may exceed 2
    position = {static_cast<int16_t>(narrowed(product(radius, cos_u), 14)), static_cast<int16_t>(narrowed(product(radius, sin_u), 14)),
                static_cast<int16_t>(narrowed(product(minor, sin_v), 13))};
    normal = narrowed(Normal30{product(cos_v, cos_u), product(cos_v, sin_u), sin_v});
}

/// Around z: a tube of radius `minor` (below 1) on a ring of radius 1.
constexpr void fill_torus(const ShapeArrays& t, uint32_t rings, uint32_t sides, Q30 minor) {
    uint32_t vertex = 0, triangle = 0;
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j, ++vertex)
            torus_vertex(t.positions[vertex], t.normals[vertex], fraction_of_turn(i, rings), fraction_of_turn(j, sides), minor);
    const auto at = [=](uint32_t i, uint32_t j) { return index16(i % rings * sides + j % sides); };
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            t.triangles[triangle++] = {at(i, j), at(i + 1, j), at(i + 1, j + 1)};
            t.triangles[triangle++] = {at(i, j), at(i + 1, j + 1), at(i, j + 1)};
        }
}

template <uint32_t Rings, uint32_t Sides>
consteval auto make_torus(Q30 minor) {
    static_assert(Rings >= 3 && Sides >= 3, "a torus has at least 3 rings and 3 sides");
    MeshData<Rings * Sides, 2 * Rings * Sides> t;
    t.fraction_bits = torus_fraction_bits;
    fill_torus({t.positions, t.normals, t.triangles}, Rings, Sides, minor);
    return t;
}

/// Edges of 2 about the origin; 24 vertices, so that each face has its own normals.
consteval auto make_cube() {
    MeshData<24, 12> c;
    c.convex = true;
    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t axis = face >> 1;
        const int16_t sign = face & 1 ? -1 : 1;
        for (uint32_t corner = 0; corner < 4; ++corner) {
            // Counter-clockwise about the normal: (-,-) (+,-) (+,+) (-,+) in the two other axes.
            int16_t v[3]{};
            const int16_t p = corner == 1 || corner == 2 ? 1 : -1, q = corner >= 2 ? 1 : -1;
            v[axis] = sign;
            v[(axis + 1) % 3] = static_cast<int16_t>(p * sign);
            v[(axis + 2) % 3] = q;
            const auto scaled = [](int16_t k) { return static_cast<int16_t>(k * 16384); };
            c.positions[face * 4 + corner] = {scaled(v[0]), scaled(v[1]), scaled(v[2])};
            const auto normal = [&](uint32_t k) { return Unit14::from_raw(k == axis ? sign * Unit14::one : 0); };
            c.normals[face * 4 + corner] = {normal(0), normal(1), normal(2)};
        }
        const uint16_t first = index16(face * 4);
        c.triangles[face * 2] = {first, index16(first + 1u), index16(first + 2u)};
        c.triangles[face * 2 + 1] = {first, index16(first + 2u), index16(first + 3u)};
    }
    return c;
}

/// Edges of 2 in the plane z = 0, facing +z.
consteval auto make_quad() {
    MeshData<4, 2> q;
    q.convex = true;
    const int16_t one = 16384, minus = -16384;
    const Position16 corners[4] = {{minus, minus, 0}, {one, minus, 0}, {one, one, 0}, {minus, one, 0}};
    for (uint32_t i = 0; i < 4; ++i) {
        q.positions[i] = corners[i];
        q.normals[i] = {{}, {}, {static_cast<int16_t>(Unit14::one)}};
    }
    q.triangles[0] = {0, 1, 2};
    q.triangles[1] = {0, 2, 3};
    return q;
}
}  // namespace detail

/// Radius 1; poles on y.
template <uint32_t Slices, uint32_t Stacks>
inline constexpr auto sphere = detail::make_sphere<Slices, Stacks>();

/// Ring radius 1, tube radius 0.4 unless it is given (Q30, below 1), around z.
template <uint32_t Rings, uint32_t Sides, int32_t MinorRadius = torus_minor_radius>
inline constexpr auto torus = detail::make_torus<Rings, Sides>({MinorRadius});

inline constexpr auto cube = detail::make_cube();
inline constexpr auto quad = detail::make_quad();

}  // namespace shade16
