// Checked C structs as the engine's own, and the engine's as C structs. What has one layout is taken as it is.
#pragma once

#include "same_layout.hpp"

namespace shade16::c {

constexpr Rgb as_rgb(shade16_color c) { return __builtin_bit_cast(Rgb, c); }
constexpr shade16_color as_color(Rgb c) { return __builtin_bit_cast(shade16_color, c); }
constexpr shade16_vec3 as_vec3(Vec3 v) { return __builtin_bit_cast(shade16_vec3, v); }
constexpr Mat3 as_mat3(const shade16_mat3& m) { return __builtin_bit_cast(Mat3, m); }
constexpr shade16_mat3 as_c(const Mat3& m) { return __builtin_bit_cast(shade16_mat3, m); }
constexpr Pose as_pose(const shade16_pose& p) { return __builtin_bit_cast(Pose, p); }
constexpr Camera as_camera(const shade16_camera& c) { return __builtin_bit_cast(Camera, c); }

/// An intensity comes in any form and is kept in the one that the engine has.
constexpr Light as_light(const shade16_light& l) {
    Light light = __builtin_bit_cast(Light, l);
    light.intensity = Scaled::normalized(l.intensity.mantissa, int32_t{l.intensity.exponent} - 32);
    return light;
}

constexpr Material as_material(const shade16_material& m) {
    Material material;
    material.ambient = as_rgb(m.ambient);
    material.diffuse = as_rgb(m.diffuse), material.specular = as_rgb(m.specular), material.emissive = as_rgb(m.emissive);
    material.shininess = Q16::from_raw(m.shininess);
    material.reflection = static_cast<Reflection>(m.reflection);
    material.shading = static_cast<Shading>(m.shading);
    material.normal_path = static_cast<NormalPath>(m.normal_path);
    material.unlit = m.unlit != 0;
    return material;
}
constexpr shade16_material as_c(const Material& m) {
    return {as_color(m.ambient_color()), as_color(m.diffuse), as_color(m.specular), as_color(m.emissive), m.shininess.raw,
            static_cast<uint8_t>(m.reflection), static_cast<uint8_t>(m.shading), static_cast<uint8_t>(m.normal_path), m.unlit};
}

/// An array in the caller's memory, read in place.
template <class T, class CType>
View<T> in_place(const CType* first, uint32_t count) {
    return first == nullptr ? View<T>{} : View<T>{reinterpret_cast<const T*>(first), count};
}
inline Mesh as_mesh(const shade16_mesh& m) {
    Mesh mesh;
    mesh.positions = in_place<Position16>(m.positions, m.vertex_count);
    mesh.normals = in_place<Normal14>(m.normals, m.vertex_count);
    mesh.colors = in_place<Rgb>(m.colors, m.vertex_count);
    mesh.triangles = in_place<Triangle>(m.triangles, m.triangle_count);
    mesh.centre = __builtin_bit_cast(Vec3, m.centre);
    mesh.fraction_bits = m.fraction_bits;
    mesh.convex = m.convex != 0;
    return mesh;
}

}  // namespace shade16::c
