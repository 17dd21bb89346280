// Scenes for the renderer's tests: each shading, light, map and camera at least once, and several together.
#pragma once

#include "shade16/shade16.hpp"

namespace shade16::host {

inline constexpr Light sun[] = {directional_light({1, 2, 3})};
inline constexpr Light lamps[] = {ambient_light(rgb(0x303030)), directional_light({1, 2, 3}, white, 0.6_scaled), point_light({-2, 1, 2}, rgb(0x4060A0)),
                           {.kind = LightKind::point, .position = {1, 1, 0}, .intensity = 0.5_scaled, .space = Space::view},
                           {.kind = LightKind::directional, .position = {0, 1, 0}, .diffuse = rgb(0x205020), .space = Space::object}};
inline constexpr Camera near_by{.eye = {0, 1, 3}, .viewer = Viewer::local};

inline constexpr Object brass_torus[] = {{.mesh = torus<24, 12>.mesh(), .material = *find_material("brass"), .pose = {.rotation = rotate_x(60_deg)}}};
inline constexpr Object flat_sphere[] = {{.mesh = sphere<16, 8>.mesh(), .material = {.diffuse = rgb(0xC04020), .shading = Shading::flat}}};
inline constexpr Object unlit_cube[] = {{.mesh = cube.mesh(), .material = {.diffuse = rgb(0xFF8855), .unlit = true}, .pose = {.rotation = rotate_y(30_deg)}}};
inline constexpr Object egg[] = {{.mesh = sphere<16, 8>.mesh(), .material = *find_material("pearl"), .pose = {.rotation = rotate_z(30_deg), .scale = {1, 0.5_q16, 2}}}};
inline constexpr Object several[] = {{.mesh = torus<24, 12>.mesh(), .material = *find_material("emerald")},
                              {.mesh = sphere<16, 8>.mesh(), .material = {.diffuse = rgb(0x8080FF), .specular = white, .shininess = 200, .shading = Shading::flat}},
                              {.mesh = quad.mesh(), .material = {.diffuse = rgb(0x333333), .unlit = true}, .pose = {.scale = {3, 3, 3}, .translation = {0, 0, -1}}},
                              {.mesh = cube.mesh(), .material = *find_material("emerald"), .pose = {.rotation = rotate_y(20_deg), .scale = {0.3_q16, 0.3_q16, 0.3_q16}}}};

constexpr Material by_pixel(Material m, NormalPath path = NormalPath::linear) {
    m.shading = Shading::phong;
    m.normal_path = path;
    return m;
}
inline constexpr Rgb corner_colors[] = {rgb(0xFF0000), rgb(0x00FF00), rgb(0x0000FF), rgb(0xFFFF00)};
constexpr Mesh colored(Mesh mesh) {
    mesh.colors = corner_colors;
    return mesh;
}
inline constexpr Object smooth_torus[] = {{.mesh = torus<24, 12>.mesh(), .material = by_pixel(*find_material("brass")), .pose = {.rotation = rotate_x(60_deg)}}};
inline constexpr Object round_torus[] = {{.mesh = torus<12, 6>.mesh(), .material = by_pixel(*find_material("brass"), NormalPath::spherical), .pose = {.rotation = rotate_x(60_deg)}}};
inline constexpr Object smooth_and_others[] = {
    {.mesh = cube.mesh(), .material = by_pixel(*find_material("jade"), NormalPath::spherical), .pose = {.rotation = rotate_y(20_deg), .translation = {-1, 0, -1}}},
    {.mesh = sphere<8, 6>.mesh(), .material = by_pixel(*find_material("ruby")), .pose = {.scale = {1, 0.5_q16, 1}}},
    {.mesh = colored(quad.mesh()), .material = by_pixel({.diffuse = white, .specular = white}), .pose = {.rotation = rotate_x(-70_deg), .scale = {2, 2, 2}, .translation = {0, -0.5_q16, 0}}},
    {.mesh = cube.mesh(), .material = *find_material("emerald"), .pose = {.rotation = rotate_y(20_deg), .scale = {0.3_q16, 0.3_q16, 0.3_q16}, .translation = {1, 0, 0}}}};

inline constexpr uint16_t checks[] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x8410, 0xFFE0, 0xF81F, 0x0000};
inline constexpr Slope8 bumps[] = {{40, 0}, {0, -90}, {-127, 30}, {12, 127}};
inline constexpr Texture chequers{checks, 2, 1};
inline constexpr SlopeMap relief{bumps, 1, 1, 6};
constexpr Material textured(Material m, Filter filter, Mapping mapping, MapPointer<SlopeMap> bump = {}) {
    m.texture = &chequers, m.bump = bump;
    m.filter = filter, m.mapping = mapping;
    return m;
}
inline constexpr Object crates[] = {
    {.mesh = textured_cube.mesh(), .material = textured(*find_material("pearl"), Filter::nearest, Mapping::perspective), .pose = {.rotation = rotate_y(30_deg)}}};
inline constexpr Object crates_and_others[] = {
    {.mesh = textured_cube.mesh(), .material = textured(*find_material("brass"), Filter::bilinear, Mapping::perspective), .pose = {.rotation = rotate_y(20_deg), .scale = {1, 0.5_q16, 1}}},
    {.mesh = colored(textured_quad.mesh()), .material = textured({.diffuse = white, .shading = Shading::flat}, Filter::nearest, Mapping::affine), .pose = {.scale = {2, 2, 2}, .translation = {0, 0, -0.5_q16}}},
    {.mesh = textured_sphere<8, 6>.mesh(), .material = by_pixel(textured(*find_material("ruby"), Filter::bilinear, Mapping::affine, &relief)), .pose = {.scale = {0.6_q16, 0.7_q16, 0.6_q16}, .translation = {0.6_q16, 0, 0.6_q16}}},
    {.mesh = textured_torus<12, 6>.mesh(), .material = textured({.diffuse = white, .unlit = true}, Filter::nearest, Mapping::perspective), .pose = {.scale = {0.5_q16, 0.5_q16, 0.5_q16}, .translation = {-0.7_q16, 0.5_q16, 0.6_q16}}},
    {.mesh = torus<24, 12>.mesh(), .material = *find_material("emerald")}};
inline constexpr Object floor_alone[] = {
    {.mesh = textured_quad.mesh(), .material = by_pixel(textured({.diffuse = white}, Filter::bilinear, Mapping::perspective, &relief), NormalPath::spherical),
     .pose = {.rotation = rotate_x(-80_deg), .scale = {8, 8, 8}, .translation = {0, -1, 0}}}};

constexpr Material by_table(Material m, LightTable table) {
    m.shading = Shading::phong, m.light_table = table;
    return m;
}
inline constexpr Object tabled[] = {
    {.mesh = torus<24, 12>.mesh(), .material = by_table(*find_material("brass"), LightTable::bilinear), .pose = {.rotation = rotate_x(60_deg)}},
    {.mesh = sphere<16, 8>.mesh(), .material = by_table(*find_material("jade"), LightTable::nearest), .pose = {.scale = {0.5_q16, 0.3_q16, 0.5_q16}}}};

inline constexpr Scene torus_scene{.camera = near_by, .lights = lamps, .objects = brass_torus, .background = rgb(0x102040)};
inline constexpr Scene flat_scene{.lights = sun, .objects = flat_sphere};
inline constexpr Scene cube_scene{.camera = {.eye = {2, 2, 4}}, .objects = unlit_cube};
inline constexpr Scene egg_scene{.camera = near_by, .lights = lamps, .objects = egg};
inline constexpr Scene map_scene{.camera = {.eye = {1, 2, 4}, .projection = Projection::orthographic, .view_height = 3}, .lights = lamps, .objects = brass_torus};
inline constexpr Scene crowd_scene{.camera = near_by, .lights = lamps, .objects = several, .background = rgb(0x203020)};
inline constexpr Scene inside_scene{.camera = {.eye = {1.2_q16, 0.9_q16, 0.9_q16}, .near_distance = 0.9_q16}, .lights = lamps, .objects = several};

inline constexpr Scene smooth_scene{.lights = sun, .objects = smooth_torus};  // no position is carried
inline constexpr Scene lamp_scene{.camera = near_by, .lights = lamps, .objects = smooth_torus};
inline constexpr Scene round_scene{.camera = near_by, .lights = lamps, .objects = round_torus};
inline constexpr Scene mixed_scene{.camera = near_by, .lights = lamps, .objects = smooth_and_others, .background = rgb(0x203020)};
inline constexpr Scene clipped_scene{.camera = {.eye = {1, 0.4_q16, 1}, .near_distance = 0.8_q16}, .lights = lamps, .objects = smooth_and_others};

inline constexpr Scene crate_scene{.camera = near_by, .lights = sun, .objects = crates};
inline constexpr Scene textured_scene{.camera = near_by, .lights = lamps, .objects = crates_and_others, .background = rgb(0x203020)};
inline constexpr Scene clipped_textured_scene{.camera = {.eye = {1.1_q16, 0.4_q16, 1}, .near_distance = 0.7_q16}, .lights = lamps, .objects = crates_and_others};
inline constexpr Scene table_scene{.camera = {.eye = {0, 1, 3}}, .lights = sun, .objects = tabled};
inline constexpr Scene unused_table_scene{.camera = near_by, .lights = lamps, .objects = tabled};  // lamps: lit pixel by pixel
inline constexpr Scene floor_scene{.camera = {.eye = {0, 0, 3}, .near_distance = 0.5_q16}, .lights = sun, .objects = floor_alone};

inline constexpr Light stage[] = {ambient_light(rgb(0x101010)),
                           spot_light({0, 3, 1}, {{0, -3, -1}, 10_deg, 20_deg, 8}, white, 2),
                           {.kind = LightKind::spot, .position = {1, 0, 0}, .space = Space::view, .range = 5, .spot = {{-0.3_q16, 0, -1}, 3_deg, 9_deg, 0}},
                           {.kind = LightKind::spot, .position = {0, 0, 2}, .space = Space::object, .attenuation = {1, 0, 0.25_q16, 0.5_q16}, .spot = {.inner = 20_deg}},
                           {.kind = LightKind::point, .position = {-1, 1, 1}, .attenuation = {.power = 1.5_q16}, .range = 2}, directional_light({1, 2, 3}, rgb(0x404040))};
inline constexpr Light ending[] = {{.kind = LightKind::point, .position = {1, 1, 1}, .range = 2.5_q16}};
inline constexpr Light falling[] = {{.kind = LightKind::point, .position = {1, 1, 1}, .attenuation = {.power = 1}}, directional_light({1, 2, 3})};
inline constexpr Material mirrored(Material m, Shading shading = Shading::gouraud) {
    m.reflection = Reflection::phong;
    m.shading = shading;
    return m;
}
inline constexpr Object mirrored_torus[] = {{.mesh = torus<24, 12>.mesh(), .material = mirrored(*find_material("gold")), .pose = {.rotation = rotate_x(60_deg)}}};
inline constexpr Object both_reflections[] = {
    {.mesh = torus<24, 12>.mesh(), .material = mirrored(*find_material("gold"), Shading::phong), .pose = {.rotation = rotate_x(60_deg), .scale = {1, 0.7_q16, 1}}},
    {.mesh = sphere<16, 8>.mesh(), .material = mirrored(*find_material("ruby"), Shading::flat), .pose = {.scale = {0.5_q16, 0.5_q16, 0.5_q16}, .translation = {0, 0, 0.5_q16}}},
    {.mesh = colored(quad.mesh()), .material = *find_material("pearl"), .pose = {.scale = {2, 2, 2}, .translation = {0, 0, -0.5_q16}}}};
inline constexpr Scene mirrored_scene{.camera = near_by, .lights = sun, .objects = mirrored_torus};
inline constexpr Scene stage_scene{.camera = near_by, .lights = stage, .objects = both_reflections, .background = rgb(0x203020)};
inline constexpr Scene ending_scene{.lights = ending, .objects = brass_torus};
inline constexpr Scene falling_scene{.camera = near_by, .lights = falling, .objects = mirrored_torus};

}  // namespace shade16::host
