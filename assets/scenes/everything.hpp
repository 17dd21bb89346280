// Made by: shade16 bake everything.toml -o everything.hpp
// 532 vertices, 968 triangles, 12216 bytes of flash.
#pragma once

#include <shade16/shade16.hpp>

namespace assets::everything {

// ground: 4 vertices, 2 triangles, 84 bytes of flash.
inline constexpr shade16::Position16 ground_positions[] = {
    {-16384, -16384, 0}, {16384, -16384, 0}, {16384, 16384, 0}, {-16384, 16384, 0},
};
inline constexpr shade16::Normal14 ground_normals[] = {
    {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}},
};
inline constexpr shade16::Rgb ground_colors[] = {
    {{12336}, {20560}, {8224}}, {{16448}, {26728}, {10280}}, {{20560}, {30840}, {12336}}, {{8224}, {14392}, {6168}},
};
inline constexpr shade16::Triangle ground_triangles[] = {
    {0, 1, 2}, {0, 2, 3},
};
inline constexpr shade16::Mesh ground{
    .positions = ground_positions,
    .normals = ground_normals,
    .colors = ground_colors,
    .triangles = ground_triangles,
    .convex = true,
};

// house_wall: 18 vertices, 10 triangles, 276 bytes of flash.
inline constexpr shade16::Position16 house_wall_positions[] = {
    {-18022, 2867, 11469}, {-18022, -13517, 11469}, {18022, -13517, 11469}, {18022, 2867, 11469}, {18022, 2867, -11469},
    {18022, -13517, -11469}, {-18022, -13517, -11469}, {-18022, 2867, -11469}, {18022, 2867, -11469}, {18022, 12697, 0},
    {18022, 2867, 11469}, {18022, -13517, -11469}, {18022, -13517, 11469}, {-18022, 2867, 11469}, {-18022, 12697, 0},
    {-18022, 2867, -11469}, {-18022, -13517, 11469}, {-18022, -13517, -11469},
};
inline constexpr shade16::Normal14 house_wall_normals[] = {
    {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {-16384}},
    {{0}, {0}, {-16384}}, {{0}, {0}, {-16384}}, {{0}, {0}, {-16384}}, {{16384}, {0}, {0}}, {{16384}, {0}, {0}},
    {{16384}, {0}, {0}}, {{16384}, {0}, {0}}, {{16384}, {0}, {0}}, {{-16384}, {0}, {0}}, {{-16384}, {0}, {0}},
    {{-16384}, {0}, {0}}, {{-16384}, {0}, {0}}, {{-16384}, {0}, {0}},
};
inline constexpr shade16::Triangle house_wall_triangles[] = {
    {0, 1, 2}, {2, 3, 0}, {4, 5, 6}, {6, 7, 4}, {8, 9, 10}, {11, 8, 10}, {10, 12, 11}, {13, 14, 15}, {16, 13, 15},
    {15, 17, 16},
};
inline constexpr shade16::Mesh house_wall{
    .positions = house_wall_positions,
    .normals = house_wall_normals,
    .triangles = house_wall_triangles,
    .centre = {0, shade16::Q16::from_raw(54068), 0},
};

// house_roof: 12 vertices, 6 triangles, 180 bytes of flash.
inline constexpr shade16::Position16 house_roof_positions[] = {
    {-19661, 13517, 0}, {-19661, 1556, 13107}, {19661, 1556, 13107}, {19661, 13517, 0}, {19661, 13517, 0},
    {19661, 1556, -13107}, {-19661, 1556, -13107}, {-19661, 13517, 0}, {19661, 1556, -13107}, {19661, 1556, 13107},
    {-19661, 1556, 13107}, {-19661, 1556, -13107},
};
inline constexpr shade16::Normal14 house_roof_normals[] = {
    {{0}, {12103}, {11044}}, {{0}, {12103}, {11044}}, {{0}, {12103}, {11044}}, {{0}, {12103}, {11044}},
    {{0}, {12103}, {-11044}}, {{0}, {12103}, {-11044}}, {{0}, {12103}, {-11044}}, {{0}, {12103}, {-11044}},
    {{0}, {-16384}, {0}}, {{0}, {-16384}, {0}}, {{0}, {-16384}, {0}}, {{0}, {-16384}, {0}},
};
inline constexpr shade16::Triangle house_roof_triangles[] = {
    {0, 1, 2}, {2, 3, 0}, {4, 5, 6}, {6, 7, 4}, {8, 9, 10}, {10, 11, 8},
};
inline constexpr shade16::Mesh house_roof{
    .positions = house_roof_positions,
    .normals = house_roof_normals,
    .triangles = house_roof_triangles,
    .centre = {0, shade16::Q16::from_raw(54068), 0},
};

// house_door: 4 vertices, 2 triangles, 60 bytes of flash.
inline constexpr shade16::Position16 house_door_positions[] = {
    {-3277, -2048, 11796}, {-3277, -13517, 11796}, {3277, -13517, 11796}, {3277, -2048, 11796},
};
inline constexpr shade16::Normal14 house_door_normals[] = {
    {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}},
};
inline constexpr shade16::Triangle house_door_triangles[] = {
    {0, 1, 2}, {2, 3, 0},
};
inline constexpr shade16::Mesh house_door{
    .positions = house_door_positions,
    .normals = house_door_normals,
    .triangles = house_door_triangles,
    .centre = {0, shade16::Q16::from_raw(54068), 0},
};

// ring: 288 vertices, 576 triangles, 6912 bytes of flash.
inline constexpr shade16::Mesh ring = shade16::torus<24, 12, 322122547>.mesh();

// ball: 182 vertices, 360 triangles, 4344 bytes of flash.
inline constexpr shade16::Mesh ball = shade16::sphere<20, 10>.mesh();

// cube: 24 vertices, 12 triangles, 360 bytes of flash.
inline constexpr shade16::Position16 cube_positions[] = {
    {16384, -16384, -16384}, {16384, 16384, -16384}, {16384, 16384, 16384}, {16384, -16384, 16384},
    {-16384, 16384, -16384}, {-16384, -16384, -16384}, {-16384, -16384, 16384}, {-16384, 16384, 16384},
    {-16384, 16384, -16384}, {-16384, 16384, 16384}, {16384, 16384, 16384}, {16384, 16384, -16384},
    {-16384, -16384, 16384}, {-16384, -16384, -16384}, {16384, -16384, -16384}, {16384, -16384, 16384},
    {-16384, -16384, 16384}, {16384, -16384, 16384}, {16384, 16384, 16384}, {-16384, 16384, 16384},
    {16384, -16384, -16384}, {-16384, -16384, -16384}, {-16384, 16384, -16384}, {16384, 16384, -16384},
};
inline constexpr shade16::Normal14 cube_normals[] = {
    {{16384}, {0}, {0}}, {{16384}, {0}, {0}}, {{16384}, {0}, {0}}, {{16384}, {0}, {0}}, {{-16384}, {0}, {0}},
    {{-16384}, {0}, {0}}, {{-16384}, {0}, {0}}, {{-16384}, {0}, {0}}, {{0}, {16384}, {0}}, {{0}, {16384}, {0}},
    {{0}, {16384}, {0}}, {{0}, {16384}, {0}}, {{0}, {-16384}, {0}}, {{0}, {-16384}, {0}}, {{0}, {-16384}, {0}},
    {{0}, {-16384}, {0}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}}, {{0}, {0}, {16384}},
    {{0}, {0}, {-16384}}, {{0}, {0}, {-16384}}, {{0}, {0}, {-16384}}, {{0}, {0}, {-16384}},
};
inline constexpr shade16::Triangle cube_triangles[] = {
    {0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {8, 9, 10}, {8, 10, 11}, {12, 13, 14}, {12, 14, 15}, {16, 17, 18},
    {16, 18, 19}, {20, 21, 22}, {20, 22, 23},
};
inline constexpr shade16::Mesh cube{
    .positions = cube_positions,
    .normals = cube_normals,
    .triangles = cube_triangles,
};
inline constexpr shade16::Mesh cube_convex{
    .positions = cube_positions,
    .normals = cube_normals,
    .triangles = cube_triangles,
    .convex = true,
};

inline constexpr shade16::Material meadow_material{
    .ambient = shade16::rgb(0x999999),
    .diffuse = shade16::white,
};

inline constexpr shade16::Material house_wall_material{
    .diffuse = shade16::Rgb{{55705}, {52428}, {42598}},
};

inline constexpr shade16::Material house_roof_material{
    .diffuse = shade16::Rgb{{45875}, {16384}, {9830}},
    .specular = shade16::Rgb{{19661}, {19661}, {19661}},
    .shininess = 40,
};

inline constexpr shade16::Material house_door_material{
    .diffuse = shade16::Rgb{{22937}, {13107}, {6554}},
    .unlit = true,
};

inline constexpr shade16::Material ruby_material{
    .ambient = shade16::Rgb{{11436}, {770}, {770}},
    .diffuse = shade16::Rgb{{40254}, {2711}, {2711}},
    .specular = shade16::Rgb{{47697}, {41088}, {41088}},
    .shininess = shade16::Q16::from_raw(5033165),
    .alpha = {36044},  // not drawn
};

inline constexpr shade16::Material facets_material{
    .ambient = shade16::Rgb{{16204}, {13074}, {4882}},
    .diffuse = shade16::Rgb{{49259}, {39746}, {14842}},
    .specular = shade16::Rgb{{41174}, {36424}, {23990}},
    .shininess = shade16::Q16::from_raw(3355443),
    .shading = shade16::Shading::flat,
};

inline constexpr shade16::Material ember_material{
    .diffuse = shade16::Rgb{{32768}, {6554}, {3277}},
    .specular = shade16::rgb(0x666666),
    .emissive = shade16::Rgb{{16384}, {1311}, {0}},
    .shininess = shade16::Q16::from_raw(622592),
};

inline constexpr shade16::Material sign_material{
    .diffuse = shade16::rgb(0xFFD060),
    .unlit = true,
};

inline constexpr shade16::Material turquoise_material{
    .ambient = shade16::Rgb{{6554}, {12271}, {11436}},
    .diffuse = shade16::Rgb{{25952}, {48595}, {45286}},
    .specular = shade16::Rgb{{19481}, {20204}, {20098}},
    .shininess = shade16::Q16::from_raw(838861),
    .alpha = {52428},  // not drawn
};

inline constexpr shade16::Light lights[] = {
    {
        .kind = shade16::LightKind::ambient,
        .diffuse = shade16::Rgb{{13107}, {13762}, {16384}},
        .specular = shade16::black,
    },
    {
        .position = {-3, 4, 5},
        .diffuse = shade16::rgb(0xFFF0D8),
        .specular = shade16::rgb(0xFFF0D8),
        .intensity = {3006477056u, 0},  // 0.7
    },
    {
        .position = {shade16::Q16::from_raw(13107), shade16::Q16::from_raw(6554), 1},  // 0.2, 0.1, 1
        .intensity = {2576979968u, -2},  // 0.15
        .space = shade16::Space::view,
    },
    {
        .kind = shade16::LightKind::point,
        // 1.2, 2.1, 2.4
        .position = {shade16::Q16::from_raw(78643), shade16::Q16::from_raw(137626), shade16::Q16::from_raw(157286)},
        .diffuse = shade16::rgb(0x6080FF),
        .specular = shade16::Rgb{{65535}, {58982}, {19661}},
        .intensity = {2684354560u, 2},  // 2.5
        .attenuation = {1, shade16::Q16::from_raw(26214), shade16::Q16::from_raw(9830)},  // 1, 0.4, 0.15
    },
    {
        .kind = shade16::LightKind::point,
        .position = {0, 3, 0},
        .diffuse = shade16::Rgb{{13107}, {6554}, {6554}},
        .specular = shade16::Rgb{{13107}, {6554}, {6554}},
        .space = shade16::Space::object,
    },
};

inline constexpr shade16::Spin spins[] = {
    {
        .start = {
            // -90, 0, 0 degrees about x, y, z; order xyz
            .rotation = {{{{1073741824}, {0}, {0}},
                          {{0}, {0}, {1073741824}},
                          {{0}, {-1073741824}, {0}}}},
            .scale = {6, 6, 6},
        },
    },
    {
        .start = {
            // 0, 25, 0 degrees about x, y, z; order xyz
            .rotation = {{{{973140577}, {0}, {453782904}},
                          {{0}, {1073741824}, {0}},
                          {{-453782904}, {0}, {973140577}}}},
            .scale = {shade16::Q16::from_raw(72090), 1, shade16::Q16::from_raw(58982)},  // 1.1, 1, 0.9
            .translation = {shade16::Q16::from_raw(-98304), 0, shade16::Q16::from_raw(-32768)},  // -1.5, 0, -0.5
        },
    },
    {
        .start = {
            // 0, 25, 0 degrees about x, y, z; order xyz
            .rotation = {{{{973140577}, {0}, {453782904}},
                          {{0}, {1073741824}, {0}},
                          {{-453782904}, {0}, {973140577}}}},
            .scale = {shade16::Q16::from_raw(72090), 1, shade16::Q16::from_raw(58982)},  // 1.1, 1, 0.9
            .translation = {shade16::Q16::from_raw(-98304), 0, shade16::Q16::from_raw(-32768)},  // -1.5, 0, -0.5
        },
    },
    {
        .start = {
            // 0, 25, 0 degrees about x, y, z; order xyz
            .rotation = {{{{973140577}, {0}, {453782904}},
                          {{0}, {1073741824}, {0}},
                          {{-453782904}, {0}, {973140577}}}},
            .scale = {shade16::Q16::from_raw(72090), 1, shade16::Q16::from_raw(58982)},  // 1.1, 1, 0.9
            .translation = {shade16::Q16::from_raw(-98304), 0, shade16::Q16::from_raw(-32768)},  // -1.5, 0, -0.5
        },
    },
    {
        .start = {
            // 0.6, 0.6, 0.6
            .scale = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322)},
            .translation = {shade16::Q16::from_raw(157286), shade16::Q16::from_raw(58982), -1},  // 2.4, 0.9, -1
        },
        .pivot = {0, shade16::Q16::from_raw(54068), 0},  // 0, 0.82501, 0
        .turns = -1,
    },
    {
        .start = {
            // 0.6, 0.6, 0.6
            .scale = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322)},
            .translation = {shade16::Q16::from_raw(157286), shade16::Q16::from_raw(58982), -1},  // 2.4, 0.9, -1
        },
        .pivot = {0, shade16::Q16::from_raw(54068), 0},  // 0, 0.82501, 0
        .turns = -1,
    },
    {
        .start = {
            // 0.6, 0.6, 0.6
            .scale = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322)},
            .translation = {shade16::Q16::from_raw(157286), shade16::Q16::from_raw(58982), -1},  // 2.4, 0.9, -1
        },
        .pivot = {0, shade16::Q16::from_raw(54068), 0},  // 0, 0.82501, 0
        .turns = -1,
    },
    {
        .start = {
            // 60, 20, 0 degrees about x, y, z; order zyx
            .rotation = {{{{1008987269}, {0}, {367241332}},
                          {{318040323}, {536870912}, {-873808607}},
                          {{-183620666}, {929887697}, {504493635}}}},
            // 0.6, 0.6, 0.6
            .scale = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322), shade16::Q16::from_raw(39322)},
            // 0.6, 0.8, 1.6
            .translation = {shade16::Q16::from_raw(39322), shade16::Q16::from_raw(52429),
                shade16::Q16::from_raw(104858)},
        },
        .turns = shade16::Q16::from_raw(98304),  // 1.5
        .axis = shade16::Axis::x,
    },
    {
        .start = {
            // 0.5, 0.7, 0.5
            .scale = {shade16::Q16::from_raw(32768), shade16::Q16::from_raw(45875), shade16::Q16::from_raw(32768)},
            .translation = {shade16::Q16::from_raw(-39322), shade16::Q16::from_raw(45875), 2},  // -0.6, 0.7, 2
        },
        .turns = 1,
        .axis = shade16::Axis::z,
    },
    {
        .start = {
            // 0.2, 0.2, 0.2
            .scale = {shade16::Q16::from_raw(13107), shade16::Q16::from_raw(13107), shade16::Q16::from_raw(13107)},
            // 1.8, 0.2, 2.2
            .translation = {shade16::Q16::from_raw(117965), shade16::Q16::from_raw(13107),
                shade16::Q16::from_raw(144179)},
        },
    },
    {
        .start = {
            // 0, 33, 0 degrees about x, y, z; order xyz
            .rotation = {{{{900515666}, {0}, {584801710}},
                          {{0}, {1073741824}, {0}},
                          {{-584801710}, {0}, {900515666}}}},
            // 0.3, 0.2, 0.25
            .scale = {shade16::Q16::from_raw(19661), shade16::Q16::from_raw(13107), shade16::Q16::from_raw(16384)},
            // -2.2, 0.2, 1.8
            .translation = {shade16::Q16::from_raw(-144179), shade16::Q16::from_raw(13107),
                shade16::Q16::from_raw(117965)},
        },
    },
};

inline constexpr shade16::Object objects[] = {
    {.mesh = ground, .material = meadow_material, .pose = spins[0].at({})},
    {.mesh = house_wall, .material = house_wall_material, .pose = spins[1].at({})},
    {.mesh = house_roof, .material = house_roof_material, .pose = spins[2].at({})},
    {.mesh = house_door, .material = house_door_material, .pose = spins[3].at({})},
    {.mesh = house_wall, .material = ruby_material, .pose = spins[4].at({})},
    {.mesh = house_roof, .material = ruby_material, .pose = spins[5].at({})},
    {.mesh = house_door, .material = ruby_material, .pose = spins[6].at({})},
    {.mesh = ring, .material = facets_material, .pose = spins[7].at({})},
    {.mesh = ball, .material = ember_material, .pose = spins[8].at({})},
    {.mesh = cube, .material = sign_material, .pose = spins[9].at({})},
    {.mesh = cube_convex, .material = turquoise_material, .pose = spins[10].at({})},
};

inline constexpr shade16::Scene scene{
    .camera = {
        .eye = {shade16::Q16::from_raw(32768), shade16::Q16::from_raw(203162), 8},  // 0.5, 3.1, 8
        .target = {0, shade16::Q16::from_raw(39322), 0},  // 0, 0.6, 0
        .viewer = shade16::Viewer::local,
        .fov_y = {459322891u},  // 38.5 degrees
        .near_distance = 2,
        .far_distance = 24,
    },
    .lights = lights,
    .objects = objects,
    .background = shade16::rgb(0x182030),
};

inline constexpr shade16::Viewport viewport{240, 160};
inline constexpr uint32_t frames = 120;
using Pixel = shade16::Rgb565Swapped;
using Tier = shade16::highp;

}  // namespace assets::everything
