// Made by: shade16 bake tables.toml -o tables.hpp
// 482 vertices, 960 triangles, 11544 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::tables {

// ball: 482 vertices, 960 triangles, 11544 bytes of flash.
inline constexpr shade16::Mesh ball = shade16::sphere<32, 16>.mesh();

inline constexpr shade16::Material nearest_material{
    .ambient = shade16::rgb(0x543907),
    .diffuse = shade16::rgb(0xC7911D),
    .specular = shade16::rgb(0xFDF0CE),
    .shininess = shade16::Q16::from_raw(1828286),
    .shading = shade16::Shading::phong,
    .light_table = shade16::LightTable::nearest,
};

inline constexpr shade16::Material bilinear_material{
    .ambient = shade16::rgb(0x543907),
    .diffuse = shade16::rgb(0xC7911D),
    .specular = shade16::rgb(0xFDF0CE),
    .shininess = shade16::Q16::from_raw(1828286),
    .shading = shade16::Shading::phong,
    .light_table = shade16::LightTable::bilinear,
};

inline constexpr shade16::Material direct_material{
    .ambient = shade16::rgb(0x543907),
    .diffuse = shade16::rgb(0xC7911D),
    .specular = shade16::rgb(0xFDF0CE),
    .shininess = shade16::Q16::from_raw(1828286),
    .shading = shade16::Shading::phong,
    .normal_path = shade16::NormalPath::spherical,
};

inline constexpr shade16::Light lights[] = {
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::Rgb{{13107}, {13107}, {16384}},
        .specular = shade16::black,
    },
    {
        .position = {-3, 4, 5},
        .intensity = {3435973888u, 0},  // 0.8
    },
    {
        .position = {5, -1, 2},
        .diffuse = shade16::Rgb{{26214}, {32768}, {58982}},
        .specular = shade16::Rgb{{26214}, {32768}, {58982}},
        .intensity = {2147483648u, 0},  // 0.5
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            .translation = {-2, 0, 0},
        },
        .turns = 1,
    },
    {
        .start = {
            // 0.95, 0.95, 0.95
            .scale = {shade16::Q16::from_raw(62259), shade16::Q16::from_raw(62259), shade16::Q16::from_raw(62259)},
        },
        .turns = 1,
        .axis = shade16::Axis::x,
    },
    {
        .start = {
            .translation = {2, 0, 0},
        },
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = ball, .material = nearest_material, .pose = spins[0].at({})},
    {.mesh = ball, .material = bilinear_material, .pose = spins[1].at({})},
    {.mesh = ball, .material = direct_material, .pose = spins[2].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, 0, 7},
        .fov_y = {298261618u},  // 25 degrees
        .near_distance = 2,
        .far_distance = 20,
    },
    .lights = lights,
    .objects = objects,
    .background = shade16::rgb(0x101820),
};

inline constexpr shade16::Viewport viewport{240, 100};
inline constexpr uint32_t frames = 60;
using Pixel = shade16::Rgb565;
using Tier = shade16::mediump;

}  // namespace assets::tables
