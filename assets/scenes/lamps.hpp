// Made by: shade16 bake lamps.toml -o lamps.hpp
// 470 vertices, 930 triangles, 11220 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::lamps {

// ground: 4 vertices, 2 triangles, 60 bytes of flash.
inline constexpr shade16::Mesh ground = shade16::quad.mesh();

// ball: 266 vertices, 528 triangles, 6360 bytes of flash.
inline constexpr shade16::Mesh ball = shade16::sphere<24, 12>.mesh();

// ring: 200 vertices, 400 triangles, 4800 bytes of flash.
inline constexpr shade16::Mesh ring = shade16::torus<20, 10, 375809638>.mesh();

inline constexpr shade16::Material floor_material{
    .specular = shade16::Rgb{{19661}, {19661}, {19661}},
    .shininess = 20,
    .shading = shade16::Shading::phong,
};

inline constexpr shade16::Material mirrored_material{
    .ambient = shade16::Rgb{{16204}, {13074}, {4882}},
    .diffuse = shade16::Rgb{{49259}, {39746}, {14842}},
    .specular = shade16::Rgb{{41174}, {36424}, {23990}},
    .shininess = shade16::Q16::from_raw(838861),
    .reflection = shade16::Reflection::phong,
};

inline constexpr shade16::Material halfway_material{
    .ambient = shade16::Rgb{{16204}, {13074}, {4882}},
    .diffuse = shade16::Rgb{{49259}, {39746}, {14842}},
    .specular = shade16::Rgb{{41174}, {36424}, {23990}},
    .shininess = shade16::Q16::from_raw(3355443),
};

inline constexpr shade16::Material facets_material{
    .diffuse = shade16::Rgb{{32768}, {32768}, {39321}},
    .specular = shade16::white,
    .shininess = 40,
    .reflection = shade16::Reflection::phong,
    .shading = shade16::Shading::flat,
};

inline constexpr shade16::Light lights[] = {
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::Rgb{{3932}, {4587}, {5898}},
        .specular = shade16::black,
    },
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::Rgb{{1966}, {1311}, {0}},
        .specular = shade16::black,
    },
    {
        .kind = shade16::LightKind::spot,
        .position = {shade16::Q16::from_raw(-144179), 4, shade16::Q16::from_raw(98304)},  // -2.2, 4, 1.5
        .diffuse = shade16::rgb(0xFFE0B0),
        .specular = shade16::rgb(0xFFE0B0),
        .intensity = {2684354560u, 5},  // 20
        .attenuation = {0, 0, 1},
        .spot = {
            .direction = {shade16::Q16::from_raw(72090), -4, shade16::Q16::from_raw(-32768)},  // 1.1, -4, -0.5
            .inner = {107374182u},  // 9 degrees
            .outer = {292296385u},  // 24.5 degrees
            .exponent = shade16::Q16::from_raw(425984),  // 6.5
        },
    },
    {
        .kind = shade16::LightKind::spot,
        .position = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(-26214), 0},  // 0.6, -0.4, 0
        .diffuse = shade16::rgb(0x80C0FF),
        .intensity = {3865470464u, 0},  // 0.9
        .space = shade16::Space::view,
        .spot = {
            .direction = {shade16::Q16::from_raw(7864), shade16::Q16::from_raw(1311), -1},  // 0.12, 0.02, -1
            .inner = {47721859u},  // 4 degrees
            .outer = {65617556u},  // 5.5 degrees
        },
    },
    {
        .kind = shade16::LightKind::spot,
        .position = {0, shade16::Q16::from_raw(26214), shade16::Q16::from_raw(163840)},  // 0, 0.4, 2.5
        .diffuse = shade16::rgb(0xFF6080),
        .specular = shade16::rgb(0xFF6080),
        .intensity = {3221225472u, 1},  // 1.5
        .space = shade16::Space::object,
        .range = shade16::Q16::from_raw(209715),  // 3.2
        .spot = {
            .direction = {0, shade16::Q16::from_raw(-6554), -1},  // 0, -0.1, -1
            .outer = {417566265u},  // 35 degrees
        },
    },
    {
        .kind = shade16::LightKind::point,
        .position = {shade16::Q16::from_raw(157286), shade16::Q16::from_raw(78643), 1},  // 2.4, 1.2, 1
        .diffuse = shade16::rgb(0x60FF90),
        .specular = shade16::rgb(0x60FF90),
        .intensity = {3006477056u, 1},  // 1.4
        .attenuation = {1, 0, 0, shade16::Q16::from_raw(49152)},  // power 0.75
        .range = shade16::Q16::from_raw(212992),  // 3.25
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            // -90, 0, 0 degrees about x, y, z; order xyz
            .rotation = {{{{1073741824}, {0}, {0}},
                          {{0}, {0}, {1073741824}},
                          {{0}, {-1073741824}, {0}}}},
            .scale = {4, 4, 4},
        },
    },
    {
        .start = {
            // 0.8, 0.8, 0.8
            .scale = {shade16::Q16::from_raw(52429), shade16::Q16::from_raw(52429), shade16::Q16::from_raw(52429)},
            // -1.2, 0.8, 0.6
            .translation = {shade16::Q16::from_raw(-78643), shade16::Q16::from_raw(52429),
                shade16::Q16::from_raw(39322)},
        },
        .turns = 1,
    },
    {
        .start = {
            // 0.6, 0.7, 0.6
            .scale = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(45875), shade16::Q16::from_raw(39322)},
            // 0.9, 0.6, 1.3
            .translation = {shade16::Q16::from_raw(58982), shade16::Q16::from_raw(39322),
                shade16::Q16::from_raw(85197)},
        },
        .turns = -1,
    },
    {
        .start = {
            // 15, 20, 0 degrees about x, y, z; order xyz
            .rotation = {{{{1008987269}, {95049051}, {354727887}},
                          {{0}, {1037154959}, {-277904834}},
                          {{-367241332}, {261145122}, {974606862}}}},
            // 0.8, 0.8, 0.8
            .scale = {shade16::Q16::from_raw(52429), shade16::Q16::from_raw(52429), shade16::Q16::from_raw(52429)},
            .translation = {1, shade16::Q16::from_raw(58982), shade16::Q16::from_raw(-78643)},  // 1, 0.9, -1.2
        },
        .turns = shade16::Q16::from_raw(32768),  // 0.5
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = ground, .material = floor_material, .pose = spins[0].at({})},
    {.mesh = ball, .material = mirrored_material, .pose = spins[1].at({})},
    {.mesh = ball, .material = halfway_material, .pose = spins[2].at({})},
    {.mesh = ring, .material = facets_material, .pose = spins[3].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {0, shade16::Q16::from_raw(222822), 7},  // 0, 3.4, 7
        .target = {0, shade16::Q16::from_raw(13107), 0},  // 0, 0.2, 0
        .viewer = shade16::Viewer::local,
        .fov_y = {477218588u},  // 40 degrees
        .near_distance = 2,
        .far_distance = 20,
    },
    .lights = lights,
    .objects = objects,
    .background = shade16::rgb(0x0C1016),
};

inline constexpr shade16::Viewport viewport{200, 150};
inline constexpr uint32_t frames = 60;
using Pixel = shade16::Rgb565;
using Tier = shade16::mediump;

}  // namespace assets::lamps
