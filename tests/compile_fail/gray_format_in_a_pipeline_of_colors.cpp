// EXPECT: a grey format is drawn by a pipeline of Channels::luma, and a format of three channels by one of Channels::rgb
#include "shade16/shade16.hpp"

using namespace shade16;

constexpr Object objects[] = {{.mesh = cube.mesh()}};
constexpr Scene scene{.objects = objects};

Workspace<scene, mediump> workspace;
Renderer<scene, mediump> renderer(workspace);
Framebuffer<Gray4, 8, 8> framebuffer;

void draw() { renderer.draw(framebuffer.band()); }
