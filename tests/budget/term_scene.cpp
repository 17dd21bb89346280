// A sphere under one light, and one term more: what a term costs, in instructions and in bytes. The build says which term.
#include <board.hpp>
#include <runtime/frame_marks.hpp>
#include <shade16/shade16.hpp>

using namespace shade16;

namespace {
/// Whether this image has a term. `with` is a list of names between blanks.
constexpr bool has(const char* name) {
    const char* with = SHADE16_TERMS;
    for (; *with != 0; ++with) {
        if (with[0] != ' ') continue;
        const char *a = with + 1, *b = name;
        for (; *b != 0 && *a == *b; ++a) ++b;
        if (*b == 0 && (*a == ' ' || *a == 0)) return true;
    }
    return false;
}

constexpr uint16_t texels[] = {0xFFFF, 0x8410, 0xFBE0, 0x07FF};
constexpr Slope8 slopes[] = {{40, 0}, {0, -40}, {-40, 0}, {0, 40}};
constexpr Texture texture{texels, 1, 1};
constexpr SlopeMap relief{slopes, 1, 1, 7};
constexpr const auto& sphere_data = textured_sphere<32, 16>;  // with or without its coordinates: the same vertices

struct Colors {
    Rgb of[sizeof(sphere_data.positions) / sizeof(sphere_data.positions[0])]{};
    constexpr Colors() {
        for (Rgb& color : of) color = rgb(0xFFC080);
    }
};
constexpr Colors colors;

constexpr Mesh make_mesh() {
    Mesh m = sphere_data.mesh();
    if (!has("texture") && !has("bump")) m.texcoords = {};
    if (has("vertex_colors")) m.colors = colors.of;
    m.convex = has("no_depth");
    return m;
}

constexpr Material make_material() {
    Material m{.diffuse = rgb(0xC08040), .shininess = 28};
    if (has("specular")) m.specular = white;
    if (has("reflected")) m.reflection = Reflection::phong;
    if (has("flat")) m.shading = Shading::flat;
    if (has("phong")) m.shading = Shading::phong;
    if (has("spherical")) m.normal_path = NormalPath::spherical;
    if (has("light_table")) m.light_table = has("bilinear") ? LightTable::bilinear : LightTable::nearest;
    if (has("texture")) m.texture = &texture;
    if (has("bump")) m.bump = &relief;
    if (has("bilinear")) m.filter = Filter::bilinear;
    if (has("perspective_texture")) m.mapping = Mapping::perspective;
    m.unlit = has("unlit");
    return m;
}

constexpr Light make_light() {
    Light light = has("point") || has("spot") ? point_light({2, 3, 4}) : directional_light({2, 3, 4});
    if (has("attenuation")) light.attenuation = {1, 0.01_q16, 0.001_q16};
    if (has("falloff")) light.attenuation.power = 0.1_q16;
    if (has("range")) light.range = 20;
    if (has("spot")) light.kind = LightKind::spot, light.spot = {{-2, -3, -4}, 20_deg, 40_deg, has("spot_exponent") ? Q16{4} : Q16{}};
    return light;
}

constexpr Light lights[] = {make_light(), ambient_light(rgb(0x303030))};
constexpr Object objects[] = {{.mesh = make_mesh(), .material = make_material(), .pose = {.scale = {1, 1, has("stretch") ? 0.9_q16 : Q16{1}}, .translation = {0, 0, -3}}}};
constexpr Scene scene{.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .projection = has("orthographic") ? Projection::orthographic : Projection::perspective,
                                 .viewer = has("local_viewer") ? Viewer::local : Viewer::infinite, .view_height = 2.5_q16},
                      .lights = {lights, has("unlit") ? 0u : has("ambient") ? 2u : 1u}, .objects = objects};
constexpr Viewport screen{320, 240};

Workspace<scene, mediump> workspace;
Framebuffer<Rgb565, screen.width, screen.height, needs_of(scene).depth> framebuffer;
}  // namespace

int main() {
    Renderer<scene, mediump> renderer(workspace);
    frame_begin();
    renderer.begin({}, screen);
    renderer.draw(framebuffer.band());
    frame_end();
    return 0;
}
