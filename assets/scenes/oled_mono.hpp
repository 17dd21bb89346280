// Made by: shade16 bake oled_mono.toml -o oled_mono.hpp
// 128 vertices, 256 triangles, 3072 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::oled_mono {

// ring: 128 vertices, 256 triangles, 3072 bytes of flash.
inline constexpr shade16::Mesh ring = shade16::torus<16, 8>.mesh();

inline constexpr shade16::Material matt_material{
    .diffuse = shade16::white,
};

inline constexpr shade16::Light lights[] = {
    {
        .position = {-2, 3, 4},
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            // 50, 0, 0 degrees about x, y, z; order xyz
            .rotation = {{{{1073741824}, {0}, {0}},
                          {{0}, {690187940}, {-822533959}},
                          {{0}, {822533959}, {690187940}}}},
        },
        .turns = 1,
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = ring, .material = matt_material, .pose = spins[0].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, 0, 5},
        .fov_y = {286331153u},  // 24 degrees
        .near_distance = 2,
        .far_distance = 10,
    },
    .lights = lights,
    .objects = objects,
};

inline constexpr shade16::Viewport viewport{96, 16};
inline constexpr uint32_t frames = 30;
using Pixel = shade16::Dithered<shade16::Mono1, shade16::bayer8>;
using Tier = shade16::mediump;

}  // namespace assets::oled_mono
