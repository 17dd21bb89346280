// A brass model on a turntable, once around.
#include <apps/turntable_scene.hpp>
#include <runtime/fits.hpp>

using namespace shade16;

static_assert(must_fit<Board, TurntableWorkspace, BoardBuffer[Board::bands], decltype(Board::display)>());

static Board board;
static TurntableWorkspace workspace;
static BoardBuffer buffers[Board::bands];

int main() {
    TurntableRenderer renderer(workspace);
    for (uint32_t stop = 0; stop < 8; ++stop) {
        const Pose pose = turntable_pose(stop);
        present(renderer, {.poses = &pose}, screen, buffers, board.display);
    }
    return 0;
}
