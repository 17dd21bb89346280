// EXPECT: this Renderer was built for fewer terms than the scene uses
#include "shade16/shade16.hpp"

using namespace shade16;

constexpr Light lights[] = {directional_light({1, 1, 1})};
constexpr Object objects[] = {{cube.mesh(), {.specular = white}}};
constexpr Scene shiny_scene{.lights = lights, .objects = objects};
constexpr Needs without_specular = [] {
    Needs needs = needs_of(shiny_scene);
    needs.specular = false;
    return needs;
}();

Workspace<shiny_scene, mediump> workspace;
Renderer<shiny_scene, mediump, VertexStore::keep, without_specular> renderer(workspace);
