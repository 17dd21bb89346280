// Made by: shade16 bake lit_cube.toml -o lit_cube.hpp
// 24 vertices, 12 triangles, 360 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::lit_cube {

// cube: 24 vertices, 12 triangles, 360 bytes of flash.
inline constexpr shade16::Mesh cube = shade16::cube.mesh();

inline constexpr shade16::Material paint_material{
    .diffuse = shade16::rgb(0xFF7F4F),
};

inline constexpr shade16::Light lights[] = {
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::rgb(0x333333),
        .specular = shade16::black,
    },
    {
        .position = {2, 5, 3},
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            // 0, -30, 0 degrees about x, y, z; order xyz
            .rotation = {{{{929887697}, {0}, {-536870912}},
                          {{0}, {1073741824}, {0}},
                          {{536870912}, {0}, {929887697}}}},
        },
        .turns = 1,
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = cube, .material = paint_material, .pose = spins[0].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, 2, 4},
        .far_distance = 10,
    },
    .lights = lights,
    .objects = objects,
    .background = shade16::rgb(0x101820),
};

inline constexpr shade16::Viewport viewport{320, 240};
inline constexpr uint32_t frames = 90;
using Pixel = shade16::Rgb565;
using Tier = shade16::mediump;

}  // namespace assets::lit_cube
