// A brass model on a turntable: the README's program. The board says which model, how large a screen and how much RAM.
#include <board.hpp>

using namespace shade16;

constexpr Light lights[] = {
    ambient_light(rgb(0x484848)),
    directional_light({-5, 5, 9}, white, 0.7_scaled),
    point_light({4, 1, 3}, rgb(0x9FB8FF), 0.25_scaled),
};
constexpr Object objects[] = {
    {.mesh = Board::model, .material = *find_material("brass")},
};
constexpr Scene scene{
    .camera = {.eye = {0, 2, 5}, .viewer = Viewer::local, .fov_y = 36_deg, .near_distance = 2, .far_distance = 9},
    .lights = lights,
    .objects = objects,
    .background = Board::background,
};
constexpr Viewport screen{Board::width_px, Board::height_px};

constexpr Channels channels = channels_of_format<Board::Pixel>;  // red, green and blue, or the luma alone
using TurntableRenderer = Renderer<scene, mediump, Board::vertex_store, needs_of(scene), channels>;

static Board board;
static Workspace<scene, mediump, Board::vertex_store, usual_slots, channels> workspace;
static BandBuffer<Board::Pixel, Board::width_px, Board::band_rows> buffers[Board::bands];

int main() {
    TurntableRenderer renderer(workspace);
    for (uint32_t step = 0; step < 8; ++step) {
        const Pose pose = centred_pose(Board::model, rotate_y(45_deg * step) * rotate_x(20_deg), Board::model_scale);
        present(renderer, {.poses = &pose}, screen, buffers, board.display);
    }
    return 0;
}
