// A frame of one triangle, compiled for whatever processor.
#include <shade16/shade16.hpp>

using namespace shade16;

constexpr auto sphere_data = sphere<8, 6>;
constexpr Light lights[] = {directional_light({1, 2, 3})};
constexpr Object objects[] = {{.mesh = sphere_data.mesh(), .material = *find_material("brass")}};
constexpr Scene scene{.camera = {.eye = {0, 0, 4}}, .lights = lights, .objects = objects};

static Workspace<scene, mediump> workspace;
static BandBuffer<Rgb565, 32, 4, needs_of(scene).depth> buffer;

extern "C" void draw() {
    Renderer<scene, mediump> renderer(workspace);
    renderer.begin({}, {32, 4});
    renderer.draw(buffer.band(0, 4));
}
