/* What turntable.rs needs of C: the teapot, and what the structs take here. */
#include "shade16.h"

#include "teapot.h"

const shade16_mesh *const c_teapot = &teapot;

#define BYTES(type) (uint32_t)sizeof(shade16_##type)
#define PLACE(type, member) (uint32_t)offsetof(shade16_##type, member)

/* Of every struct its size and where its last member lies, in the order of turntable.rs. */
const uint32_t c_layouts[][2] = {
    {BYTES(vec3), PLACE(vec3, z)},
    {BYTES(mat3), PLACE(mat3, row)},
    {BYTES(color), PLACE(color, b)},
    {BYTES(scaled), PLACE(scaled, exponent)},
    {BYTES(position), PLACE(position, z)},
    {BYTES(normal), PLACE(normal, z)},
    {BYTES(triangle), PLACE(triangle, c)},
    {BYTES(mesh), PLACE(mesh, convex)},
    {BYTES(material), PLACE(material, unlit)},
    {BYTES(attenuation), PLACE(attenuation, power)},
    {BYTES(spot), PLACE(spot, exponent)},
    {BYTES(light), PLACE(light, spot)},
    {BYTES(camera), PLACE(camera, far_distance)},
    {BYTES(pose), PLACE(pose, translation)},
    {BYTES(object), PLACE(object, pose)},
    {BYTES(scene), PLACE(scene, height_px)},
    {BYTES(frame), PLACE(frame, component)},
};
const uint32_t c_layout_count = sizeof(c_layouts) / sizeof(c_layouts[0]);
