// C structs whose memory the engine reads as its own: held here to the same layout, member by member.
#pragma once

#include "shade16.h"
#include "shade16/scene/scene.hpp"

namespace shade16::c {

#define SHADE16_C_SAME_SIZE(Type, c_type) static_assert(sizeof(Type) == sizeof(c_type) && alignof(Type) == alignof(c_type))
#define SHADE16_C_SAME(Type, member, c_type, c_member) \
    static_assert(offsetof(Type, member) == offsetof(c_type, c_member) && sizeof(Type::member) == sizeof(c_type::c_member))

SHADE16_C_SAME_SIZE(Vec3, shade16_vec3);
SHADE16_C_SAME(Vec3, x, shade16_vec3, x);
SHADE16_C_SAME(Vec3, y, shade16_vec3, y);
SHADE16_C_SAME(Vec3, z, shade16_vec3, z);
SHADE16_C_SAME_SIZE(Mat3, shade16_mat3);
SHADE16_C_SAME_SIZE(Normal30, int32_t[3]);

SHADE16_C_SAME_SIZE(Position16, shade16_position);
SHADE16_C_SAME(Position16, x, shade16_position, x);
SHADE16_C_SAME(Position16, y, shade16_position, y);
SHADE16_C_SAME(Position16, z, shade16_position, z);
SHADE16_C_SAME_SIZE(Normal14, shade16_normal);
SHADE16_C_SAME(Normal14, x, shade16_normal, x);
SHADE16_C_SAME(Normal14, y, shade16_normal, y);
SHADE16_C_SAME(Normal14, z, shade16_normal, z);
SHADE16_C_SAME_SIZE(Rgb, shade16_color);
SHADE16_C_SAME(Rgb, r, shade16_color, r);
SHADE16_C_SAME(Rgb, g, shade16_color, g);
SHADE16_C_SAME(Rgb, b, shade16_color, b);
SHADE16_C_SAME_SIZE(Triangle, shade16_triangle);
SHADE16_C_SAME(Triangle, a, shade16_triangle, a);
SHADE16_C_SAME(Triangle, b, shade16_triangle, b);
SHADE16_C_SAME(Triangle, c, shade16_triangle, c);

SHADE16_C_SAME_SIZE(Pose, shade16_pose);
SHADE16_C_SAME(Pose, rotation, shade16_pose, rotation);
SHADE16_C_SAME(Pose, scale, shade16_pose, scale);
SHADE16_C_SAME(Pose, translation, shade16_pose, translation);

SHADE16_C_SAME_SIZE(Camera, shade16_camera);
SHADE16_C_SAME(Camera, eye, shade16_camera, eye);
SHADE16_C_SAME(Camera, target, shade16_camera, target);
SHADE16_C_SAME(Camera, up, shade16_camera, up);
SHADE16_C_SAME(Camera, projection, shade16_camera, projection);
SHADE16_C_SAME(Camera, viewer, shade16_camera, viewer);
SHADE16_C_SAME(Camera, fov_y, shade16_camera, fov_y);
SHADE16_C_SAME(Camera, view_height, shade16_camera, view_height);
SHADE16_C_SAME(Camera, near_distance, shade16_camera, near_distance);
SHADE16_C_SAME(Camera, far_distance, shade16_camera, far_distance);

SHADE16_C_SAME_SIZE(Scaled, shade16_scaled);
SHADE16_C_SAME(Scaled, mantissa, shade16_scaled, mantissa);
SHADE16_C_SAME(Scaled, exponent, shade16_scaled, exponent);
SHADE16_C_SAME_SIZE(Attenuation, shade16_attenuation);
SHADE16_C_SAME(Attenuation, constant, shade16_attenuation, constant);
SHADE16_C_SAME(Attenuation, linear, shade16_attenuation, linear);
SHADE16_C_SAME(Attenuation, quadratic, shade16_attenuation, quadratic);
SHADE16_C_SAME(Attenuation, power, shade16_attenuation, power);
SHADE16_C_SAME_SIZE(Spot, shade16_spot);
SHADE16_C_SAME(Spot, direction, shade16_spot, direction);
SHADE16_C_SAME(Spot, inner, shade16_spot, inner);
SHADE16_C_SAME(Spot, outer, shade16_spot, outer);
SHADE16_C_SAME(Spot, exponent, shade16_spot, exponent);
SHADE16_C_SAME_SIZE(Light, shade16_light);
SHADE16_C_SAME(Light, kind, shade16_light, kind);
SHADE16_C_SAME(Light, position, shade16_light, position);
SHADE16_C_SAME(Light, diffuse, shade16_light, diffuse);
SHADE16_C_SAME(Light, specular, shade16_light, specular);
SHADE16_C_SAME(Light, intensity, shade16_light, intensity);
SHADE16_C_SAME(Light, space, shade16_light, space);
SHADE16_C_SAME(Light, attenuation, shade16_light, attenuation);
SHADE16_C_SAME(Light, range, shade16_light, range);
SHADE16_C_SAME(Light, spot, shade16_light, spot);

#undef SHADE16_C_SAME
#undef SHADE16_C_SAME_SIZE

/// Whether a constant of the C header has the value of the C++ one.
template <class Enum>
constexpr bool is(int constant, Enum value) { return constant == static_cast<int>(value); }

static_assert(is(SHADE16_LIGHT_AMBIENT, LightKind::ambient) && is(SHADE16_LIGHT_DIRECTIONAL, LightKind::directional) &&
              is(SHADE16_LIGHT_POINT, LightKind::point) && is(SHADE16_LIGHT_SPOT, LightKind::spot));
static_assert(is(SHADE16_SPACE_WORLD, Space::world) && is(SHADE16_SPACE_VIEW, Space::view) && is(SHADE16_SPACE_OBJECT, Space::object));
static_assert(is(SHADE16_PERSPECTIVE, Projection::perspective) && is(SHADE16_ORTHOGRAPHIC, Projection::orthographic));
static_assert(is(SHADE16_VIEWER_INFINITE, Viewer::infinite) && is(SHADE16_VIEWER_LOCAL, Viewer::local));
static_assert(is(SHADE16_SHADING_FLAT, Shading::flat) && is(SHADE16_SHADING_GOURAUD, Shading::gouraud) && is(SHADE16_SHADING_PHONG, Shading::phong));
static_assert(is(SHADE16_NORMALS_LINEAR, NormalPath::linear) && is(SHADE16_NORMALS_SPHERICAL, NormalPath::spherical));
static_assert(is(SHADE16_REFLECTION_BLINN_PHONG, Reflection::blinn_phong) && is(SHADE16_REFLECTION_PHONG, Reflection::phong));
static_assert(is(SHADE16_COMPONENT_ALL, Component::all) && is(SHADE16_COMPONENT_AMBIENT, Component::ambient) &&
              is(SHADE16_COMPONENT_DIFFUSE, Component::diffuse) && is(SHADE16_COMPONENT_SPECULAR, Component::specular));
static_assert(SHADE16_MAX_VERTICES == max_mesh_vertices);

}  // namespace shade16::c
