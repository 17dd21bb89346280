// A scene that `shade16 bake` made of a scene file, drawn a whole frame at once. What turns is shown at four moments of
// the animation. The build says which scene: see scenes.cmake.
#include SHADE16_SCENE_HEADER

#include <runtime/frame_marks.hpp>
#include <runtime/hash_sink.hpp>

using namespace shade16;
namespace baked = assets::SHADE16_SCENE;

#ifdef SHADE16_TIER
using Tier = SHADE16_TIER;
#else
using Tier = baked::Tier;
#endif
#ifdef SHADE16_FORMAT
using Pixel = SHADE16_FORMAT;
#else
using Pixel = baked::Pixel;
#endif
constexpr Channels channels = channels_of_format<Pixel>;

constexpr bool turns() {
    for (const Spin& spin : baked::spins)
        if (spin.turns != Q16{}) return true;
    return false;
}
constexpr uint32_t moments = turns() ? 4 : 1;
constexpr int32_t width = baked::viewport.width, height = baked::viewport.height;

using SceneRenderer = Renderer<baked::scene, Tier, VertexStore::keep, needs_of(baked::scene), channels>;
static Workspace<baked::scene, Tier, VertexStore::keep, usual_slots, channels> workspace;
static Framebuffer<Pixel, width, height, needs_of(baked::scene).depth> framebuffer;
static HashSinkOf<Pixel> display;

static void draw(SceneRenderer& renderer, const Frame& frame) {
    frame_begin();
    renderer.begin(frame, baked::viewport);
    renderer.draw(framebuffer.band());
    frame_end();
    display.flush({0, 0, width, height}, framebuffer.pixels, sizeof(framebuffer.pixels), true);
    display.wait();
}

int main() {
    SceneRenderer renderer(workspace);
    Pose poses[baked::scene.objects.count];
    for (uint32_t moment = 0; moment < moments; ++moment) {
        for (uint32_t i = 0; i < baked::scene.objects.count; ++i)
            poses[i] = baked::spins[i].at(elapsed(moment, moments));
        draw(renderer, {.poses = poses});
    }
    return 0;
}
