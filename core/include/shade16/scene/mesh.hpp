// Mesh: quantised triangles, as they lie in flash.
#pragma once

#include "shade16/num/unorm.hpp"
#include "shade16/num/vec.hpp"
#include "shade16/scene/texture.hpp"
#include "shade16/scene/view.hpp"

namespace shade16 {

/// A position on the mesh's lattice.
struct Position16 {
    int16_t x = 0, y = 0, z = 0;
    friend constexpr bool operator==(Position16, Position16) = default;
};
constexpr IVec3 raw(Position16 p) { return {p.x, p.y, p.z}; }

/// Counter-clockwise as seen from outside.
struct Triangle {
    uint16_t a = 0, b = 0, c = 0;
    friend constexpr bool operator==(Triangle, Triangle) = default;
};

/// A triangle mesh: 12 bytes a vertex, 6 a triangle, 6 more a vertex with colours, 4 with texture
/// coordinates.
/// A vertex stands at centre + position * 2^-fraction_bits; the parts of one model share both, so that they meet exactly.
struct Mesh {
    View<Position16> positions{};
    View<Normal14> normals{};  // unit length within 2^-13; may be empty when nothing smooth is lit
    View<Rgb> colors{};        // a factor on ambient and diffuse, or the colour itself when unlit; may be empty
    View<TexCoord16> texcoords{};  // may be empty: then no texture shows
    View<Triangle> triangles{};
    Vec3 centre{};
    int8_t fraction_bits = 14;  // 0 to 30
    int8_t texcoord_bits = 14;  // 0 to 15
    bool convex = false;        // as verified by `shade16 bake`: drawn alone it needs no depth buffer
};

inline constexpr uint32_t max_mesh_vertices = 65535;

}  // namespace shade16
