// A brass model on a turntable: what the apps draw on a board's screen. The board says which model, how large a screen and how much RAM.
#pragma once

#include <board.hpp>

namespace shade16 {

inline constexpr Light turntable_lights[] = {
    ambient_light(rgb(0x484848)),
    directional_light({-5, 5, 9}, white, 0.7_scaled),
    point_light({4, 1, 3}, rgb(0x9FB8FF), 0.25_scaled),
};
inline constexpr Object turntable_objects[] = {
    {.mesh = Board::model, .material = *find_material("brass")},
};
inline constexpr Scene turntable{
    .camera = {.eye = {0, 2, 5}, .viewer = Viewer::local, .fov_y = 36_deg, .near_distance = 2, .far_distance = 9},
    .lights = turntable_lights,
    .objects = turntable_objects,
    .background = Board::background,
};
inline constexpr Viewport screen{Board::width_px, Board::height_px};

inline constexpr Channels channels = channels_of_format<Board::Pixel>;  // red, green and blue, or the luma alone
using TurntableRenderer = Renderer<turntable, mediump, Board::vertex_store, needs_of(turntable), channels>;
using TurntableWorkspace = Workspace<turntable, mediump, Board::vertex_store, usual_slots, channels>;
using BoardBuffer = BandBuffer<Board::Pixel, Board::width_px, Board::band_rows>;

/// The table has eight stops.
constexpr Pose turntable_pose(uint32_t stop) {
    return centred_pose(Board::model, rotate_y(45_deg * stop) * rotate_x(20_deg), Board::model_scale);
}

}  // namespace shade16
