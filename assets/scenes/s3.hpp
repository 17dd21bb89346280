// Made by: shade16 bake s3.toml -o s3.hpp
// 4 vertices, 2 triangles, 84 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::s3 {

// quad: 4 vertices, 2 triangles, 84 bytes of flash.
inline constexpr shade16::Position16 quad_positions[] = {
    {-18916, -14187, 0}, {18916, -14187, 0}, {18916, 14187, 0}, {-18916, 14187, 0},
};
inline constexpr shade16::Normal14 quad_normals[] = {
    {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}},
};
inline constexpr shade16::Rgb quad_colors[] = {
    {{0}, {0}, {65535}}, {{65535}, {65535}, {0}}, {{0}, {65535}, {0}}, {{65535}, {0}, {0}},
};
inline constexpr shade16::Triangle quad_triangles[] = {
    {0, 1, 2}, {0, 2, 3},
};
inline constexpr shade16::Mesh quad{
    .positions = quad_positions,
    .normals = quad_normals,
    .colors = quad_colors,
    .triangles = quad_triangles,
    .fraction_bits = 13,
};

inline constexpr shade16::Material painted_material{
    .diffuse = shade16::white,
    .unlit = true,
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            .translation = {0, 0, -3},
        },
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = quad, .material = painted_material, .pose = spins[0].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, 0, 0},
        .target = {0, 0, -1},
        .fov_y = {715827883u},  // 60 degrees
        .far_distance = 10,
    },
    .objects = objects,
};

inline constexpr shade16::Viewport viewport{320, 240};
inline constexpr uint32_t frames = 1;
using Pixel = shade16::Rgb565;
using Tier = shade16::mediump;

}  // namespace assets::s3
