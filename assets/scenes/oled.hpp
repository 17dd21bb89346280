// Made by: shade16 bake oled.toml -o oled.hpp
// 374 vertices, 744 triangles, 8952 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::oled {

// ring: 288 vertices, 576 triangles, 6912 bytes of flash.
inline constexpr shade16::Mesh ring = shade16::torus<24, 12>.mesh();

// ball: 86 vertices, 168 triangles, 2040 bytes of flash.
inline constexpr shade16::Mesh ball = shade16::sphere<12, 8>.mesh();

inline constexpr shade16::Material brass_material{
    .diffuse = shade16::rgb(0xC8912D),
    .specular = shade16::rgb(0xFDE8A0),
    .shininess = 28,
};

inline constexpr shade16::Material ball_material{
    .diffuse = shade16::rgb(0x5070D0),
    .specular = shade16::rgb(0xC0C0C0),
    .shininess = 60,
    .shading = shade16::Shading::phong,
};

inline constexpr shade16::Light lights[] = {
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::rgb(0x404040),
        .specular = shade16::black,
    },
    {
        .position = {-3, 4, 5},
    },
    {
        .kind = shade16::LightKind::point,
        .position = {3, 1, 2},
        .diffuse = shade16::rgb(0x4060FF),
        .specular = shade16::rgb(0x4060FF),
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            // 70, 0, 20 degrees about x, y, z; order xyz
            .rotation = {{{{1008987269}, {-125603933}, {345093970}},
                          {{367241332}, {345093970}, {-948137891}},
                          {{0}, {1008987269}, {367241332}}}},
        },
        .turns = 1,
    },
    {
        .start = {
            // 0.5, 0.5, 0.5
            .scale = {shade16::Q16::from_raw(32768), shade16::Q16::from_raw(32768), shade16::Q16::from_raw(32768)},
        },
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = ring, .material = brass_material, .pose = spins[0].at({})},
    {.mesh = ball, .material = ball_material, .pose = spins[1].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, 1, 5},
        .viewer = shade16::Viewer::local,
        .fov_y = {429496730u},  // 36 degrees
        .near_distance = 2,
        .far_distance = 10,
    },
    .lights = lights,
    .objects = objects,
};

inline constexpr shade16::Viewport viewport{128, 64};
inline constexpr uint32_t frames = 60;
using Pixel = shade16::Dithered<shade16::Gray4, shade16::bayer4>;
using Tier = shade16::mediump;

}  // namespace assets::oled
