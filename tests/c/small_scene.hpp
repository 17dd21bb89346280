// A square under a light, which a test spoils.
#pragma once

#include <cstring>
#include <vector>

#include "shade16.h"

struct SmallScene {
    static constexpr int32_t width = 16, height = 12;
    shade16_position positions[4]{{-16384, -16384, 0}, {16384, -16384, 0}, {16384, 16384, 0}, {-16384, 16384, 0}};
    shade16_normal normals[4]{{0, 0, 16384}, {0, 0, 16384}, {0, 0, 16384}, {0, 0, 16384}};
    shade16_color colors[4]{{65535, 0, 0}, {0, 65535, 0}, {0, 0, 65535}, {65535, 65535, 65535}};
    shade16_triangle triangles[2]{{0, 1, 2}, {0, 2, 3}};
    shade16_mesh mesh{positions, normals, nullptr, triangles, 4, 2, {0, 0, 0}, 14, 1};
    shade16_light lights[1]{shade16_directional_light({0, 0, 65536}, shade16_rgb(0xFFFFFF), SHADE16_INTENSITY(1, 1))};
    shade16_object objects[2]{{&mesh, shade16_default_material(), shade16_default_pose()}, {&mesh, shade16_default_material(), shade16_default_pose()}};
    shade16_scene scene{shade16_default_camera(), lights, objects, 1, 1, {0, 0, 0}, width, height};

    std::vector<uint64_t> memory = std::vector<uint64_t>(4096);
    std::vector<uint16_t> pixels = std::vector<uint16_t>(width * height), depth = std::vector<uint16_t>(width * height);
    shade16_renderer* renderer = nullptr;

    shade16_status init() { return shade16_init(memory.data(), memory.size() * 8, &scene, &renderer); }
    shade16_status begin(const shade16_frame* frame = nullptr) { return shade16_begin(renderer, frame); }
    shade16_status draw(int32_t first_row = 0, int32_t rows = height) {
        return shade16_draw_rgb565(renderer, pixels.data(), depth.data(), first_row, rows);
    }
};
