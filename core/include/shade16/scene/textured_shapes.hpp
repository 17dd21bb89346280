// The built-in shapes with texture coordinates, for scenes that have a texture. Seams have vertices of their own, so that a
// texture ends and begins there.
#pragma once

#include "shade16/scene/shapes.hpp"

namespace shade16 {

/// MeshData with a place in the texture for every vertex, 0 to 1.
template <uint32_t Vertices, uint32_t Triangles>
struct TexturedMeshData : MeshData<Vertices, Triangles> {
    TexCoord16 texcoords[Vertices]{};

    constexpr Mesh mesh() const {
        Mesh m = MeshData<Vertices, Triangles>::mesh();
        m.texcoords = texcoords;
        return m;
    }
};

namespace detail {
inline constexpr int16_t texcoord_one = 16384;

constexpr int16_t texcoord_fraction(uint32_t i, uint32_t n) { return static_cast<int16_t>((uint32_t{texcoord_one} * i + n / 2) / n); }

/// Two triangles for each cell of a grid of (columns + 1) x (rows + 1) vertices, in rows from the top; at a pole, where a row is
/// one point, one.
constexpr void fill_grid(Triangle* triangles, uint32_t columns, uint32_t rows, bool has_poles) {
    for (uint32_t i = 0; i < rows; ++i)
        for (uint32_t j = 0; j < columns; ++j) {
            const uint16_t here = index16(i * (columns + 1) + j), right = index16(here + 1u);
            const uint16_t below = index16(here + columns + 1), beyond = index16(below + 1u);
            if (!has_poles || i + 1 < rows) *triangles++ = {here, below, beyond};
            if (!has_poles || i > 0) *triangles++ = {here, has_poles && i + 1 == rows ? below : beyond, right};
        }
}

constexpr uint32_t grid_vertices(uint32_t columns, uint32_t rows) { return (columns + 1) * (rows + 1); }

/// s runs eastwards, t from the south pole to the north pole.
constexpr void fill_textured_sphere(const ShapeArrays& s, TexCoord16* texcoords, uint32_t slices, uint32_t stacks) {
    uint32_t vertex = 0;
    for (uint32_t i = 0; i <= stacks; ++i) {
        const auto [sin_t, cos_t] = sincos(fraction_of_turn(i, 2 * stacks));
        for (uint32_t j = 0; j <= slices; ++j) {
            const auto [sin_p, cos_p] = sincos(fraction_of_turn(j, slices));
            const Normal30 unit{product(sin_t, sin_p), cos_t, product(sin_t, cos_p)};
            s.positions[vertex] = {static_cast<int16_t>(narrowed(unit.x, 14)), static_cast<int16_t>(narrowed(unit.y, 14)), static_cast<int16_t>(narrowed(unit.z, 14))};
            s.normals[vertex] = narrowed(unit);
            texcoords[vertex++] = {texcoord_fraction(j, slices), texcoord_fraction(stacks - i, stacks)};
        }
    }
    fill_grid(s.triangles, slices, stacks, true);
}

/// s runs around the ring, t around the tube.
constexpr void fill_textured_torus(const ShapeArrays& t, TexCoord16* texcoords, uint32_t rings, uint32_t sides, Q30 minor) {
    uint32_t vertex = 0;
    for (uint32_t i = 0; i <= rings; ++i)
        for (uint32_t j = 0; j <= sides; ++j) {
            torus_vertex(t.positions[vertex], t.normals[vertex], fraction_of_turn(i, rings), fraction_of_turn(j, sides), minor);
            texcoords[vertex++] = {texcoord_fraction(i, rings), texcoord_fraction(j, sides)};
        }
    fill_grid(t.triangles, sides, rings, false);
}

template <uint32_t Slices, uint32_t Stacks>
consteval auto make_textured_sphere() {
    static_assert(Slices >= 3 && Stacks >= 2, "a sphere has at least 3 slices and 2 stacks");
    TexturedMeshData<grid_vertices(Slices, Stacks), sphere_triangles(Slices, Stacks)> s;
    fill_textured_sphere({s.positions, s.normals, s.triangles}, s.texcoords, Slices, Stacks);
    return s;
}

template <uint32_t Rings, uint32_t Sides>
consteval auto make_textured_torus(Q30 minor) {
    static_assert(Rings >= 3 && Sides >= 3, "a torus has at least 3 rings and 3 sides");
    TexturedMeshData<grid_vertices(Rings, Sides), 2 * Rings * Sides> t;
    t.fraction_bits = torus_fraction_bits;
    fill_textured_torus({t.positions, t.normals, t.triangles}, t.texcoords, Rings, Sides, minor);
    return t;
}

/// The corners of a picture, counter-clockwise from the lower left.
inline constexpr TexCoord16 picture_corners[4] = {{0, 0}, {texcoord_one, 0}, {texcoord_one, texcoord_one}, {0, texcoord_one}};

/// Every face shows the whole picture, upright on the four sides.
consteval auto make_textured_cube() {
    TexturedMeshData<24, 12> c;
    static_cast<MeshData<24, 12>&>(c) = make_cube();
    constexpr uint32_t turn[6] = {1, 3, 3, 3, 0, 0};  // quarters, by face: +x, -x, +y, -y, +z, -z
    for (uint32_t i = 0; i < 24; ++i) c.texcoords[i] = picture_corners[(i + turn[i >> 2]) & 3];
    return c;
}

consteval auto make_textured_quad() {
    TexturedMeshData<4, 2> q;
    static_cast<MeshData<4, 2>&>(q) = make_quad();
    for (uint32_t i = 0; i < 4; ++i) q.texcoords[i] = picture_corners[i];
    return q;
}
}  // namespace detail

template <uint32_t Slices, uint32_t Stacks>
inline constexpr auto textured_sphere = detail::make_textured_sphere<Slices, Stacks>();

template <uint32_t Rings, uint32_t Sides, int32_t MinorRadius = torus_minor_radius>
inline constexpr auto textured_torus = detail::make_textured_torus<Rings, Sides>({MinorRadius});

inline constexpr auto textured_cube = detail::make_textured_cube();
inline constexpr auto textured_quad = detail::make_textured_quad();

}  // namespace shade16
