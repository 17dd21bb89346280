// Grey and dithered targets, drawn by the whole pipeline: what lies in memory is what the colours before rounding say, in
// bands of any height, at any width, for every kind of painter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/engine/codes.hpp"
#include "shade16/shade16.hpp"

namespace shade16 {
namespace {

constexpr Rgb corner_colors[] = {rgb(0xFF0000), rgb(0x00FF00), rgb(0x0000FF), rgb(0xFFFF00)};
constexpr Mesh colored_quad() {
    Mesh mesh = quad.mesh();
    mesh.colors = corner_colors;
    return mesh;
}
// A needle a hundred times as long as wide, and a screen full of it: slivers, and triangles that the near plane cuts.
constexpr Object everything[] = {
    {.mesh = torus<12, 6>.mesh(), .material = *find_material("brass"), .pose = {.rotation = rotate_x(60_deg), .scale = {0.7_q16, 0.7_q16, 0.7_q16}}},
    {.mesh = sphere<8, 6>.mesh(), .material = {.diffuse = rgb(0x40C0FF), .specular = white, .shading = Shading::phong}, .pose = {.scale = {0.5_q16, 0.5_q16, 0.5_q16}, .translation = {0.6_q16, 0.2_q16, 0.3_q16}}},
    {.mesh = cube.mesh(), .material = {.diffuse = rgb(0xC04020), .shading = Shading::flat}, .pose = {.rotation = rotate_y(30_deg), .scale = {0.4_q16, 0.4_q16, 0.4_q16}, .translation = {-0.7_q16, -0.3_q16, 0.5_q16}}},
    {.mesh = colored_quad(), .material = {.diffuse = white, .unlit = true}, .pose = {.rotation = rotate_x(-80_deg), .scale = {3, 8, 3}, .translation = {0, -0.8_q16, 0}}},
    {.mesh = colored_quad(), .material = {.diffuse = white, .specular = white, .shading = Shading::phong}, .pose = {.rotation = rotate_y(89_deg), .scale = {3, 0.03_q16, 1}, .translation = {0.1_q16, 0.5_q16, 1}}}};
constexpr Light lamps[] = {ambient_light(rgb(0x303030)), directional_light({1, 2, 3}, white, 0.6_scaled), point_light({-2, 1, 2}, rgb(0x4060A0))};
constexpr Scene scene{.camera = {.eye = {0, 1, 3}, .viewer = Viewer::local, .near_distance = 1}, .lights = lamps, .objects = everything, .background = rgb(0x335577)};

template <class Format, class Tier, VertexStore Store = VertexStore::keep>
std::vector<typename Format::Pixel> drawn(Viewport screen, int32_t rows) {
    constexpr Channels channels = channels_of_format<Format>;
    auto memory = std::make_unique<Workspace<scene, Tier, Store, usual_slots, channels>>();
    Renderer<scene, Tier, Store, needs_of(scene), channels> renderer(*memory);
    const int32_t stride = pixels_a_row<Format>(screen.width);
    std::vector<typename Format::Pixel> pixels(static_cast<std::size_t>(stride * screen.height));
    std::vector<uint16_t> depth(static_cast<std::size_t>(screen.width * rows));
    renderer.begin({}, screen);
    for (int32_t y = 0; y < screen.height; y += rows)
        renderer.draw(Band<Format>{pixels.data() + y * stride, depth.data(), screen.width, y, std::min(rows, screen.height - y)});
    return pixels;
}

/// One channel's code at a place, by the words of the documentation.
uint32_t shown(uint32_t with_half, const BayerMatrix* matrix, int32_t x, int32_t y) {
    if (matrix == nullptr) return with_half >> 24;
    const int thresholds = matrix->side * matrix->side;
    const double code = with_half / 16777216.0 - 0.5;
    return static_cast<uint32_t>(std::floor(code + (matrix->thresholds[y % matrix->side][x % matrix->side] + 0.5) / thresholds));
}
template <class Format>
constexpr const BayerMatrix* matrix_of() {
    if constexpr (DitheredFormat<Format>) return &Format::matrix;
    else return nullptr;
}

template <class Format, class Tier>
void expect_codes_in_memory(Viewport screen) {
    constexpr bool gray = GrayFormat<Format>;
    const auto codes = drawn<typename host::UnroundedOf<Format>::type, Tier>(screen, screen.height);
    const auto memory = drawn<Format, Tier>(screen, screen.height);
    for (int32_t y = 0; y < screen.height; ++y)
        for (int32_t x = 0; x < screen.width; ++x) {
            const auto& exact = codes[static_cast<std::size_t>(y * screen.width + x)];
            const auto code = [&](uint32_t q24) { return shown(q24, matrix_of<Format>(), x, y); };
            if constexpr (gray) {
                const int bits = Format::luma_bits, from_left = x * bits;
                const uint8_t byte = memory[static_cast<std::size_t>(y * ((screen.width * bits + 7) / 8) + from_left / 8)];
                ASSERT_EQ(uint32_t{byte} >> (8 - bits - from_left % 8) & ((1u << bits) - 1), code(exact.luma)) << x << ' ' << y;
            } else {
                const uint16_t expected = Format::pack(code(exact.r), code(exact.g), code(exact.b));
                ASSERT_EQ(memory[static_cast<std::size_t>(y * screen.width + x)], expected) << x << ' ' << y;
            }
        }
}

template <class Format, class Tier = mediump>
void expect_right_target() {
    for (const int32_t width : {1, 3, 7, 9, 13, 60}) {
        const Viewport screen{width, width < 20 ? 11 : 45};
        expect_codes_in_memory<Format, Tier>(screen);
        const auto whole = drawn<Format, Tier>(screen, screen.height);
        for (const int32_t rows : {1, 2, 3, 5, 8}) ASSERT_EQ((drawn<Format, Tier>(screen, rows)), whole) << width << " wide, bands of " << rows;
    }
    EXPECT_EQ((drawn<Format, Tier, VertexStore::replay>({13, 11}, 3)), (drawn<Format, Tier>({13, 11}, 11)));
}

TEST(Target, Gray8) { expect_right_target<Gray8>(); }
TEST(Target, Gray4) { expect_right_target<Gray4>(); }
TEST(Target, Gray4Dithered) { expect_right_target<Dithered<Gray4, bayer4>>(); }
TEST(Target, Mono1Dithered) { expect_right_target<Dithered<Mono1, bayer8>, lowp>(); }
TEST(Target, Rgb565Dithered) { expect_right_target<Dithered<Rgb565, bayer4>>(); }
TEST(Target, SwappedDitheredInHighp) { expect_right_target<Dithered<Rgb565Swapped, bayer8>, highp>(); }

// A scene of greys has one channel, whatever lights it.
constexpr Rgb gray_corners[] = {rgb(0x101010), rgb(0x606060), rgb(0xC0C0C0), white};
constexpr Mesh gray_quad() {
    Mesh mesh = quad.mesh();
    mesh.colors = gray_corners;
    return mesh;
}
constexpr Object gray_objects[] = {{.mesh = sphere<8, 6>.mesh(), .material = {.diffuse = rgb(0x808080), .specular = rgb(0x999999)}}, {.mesh = gray_quad(), .material = {.diffuse = rgb(0x707070)}}};
constexpr Light gray_lamps[] = {ambient_light(rgb(0x202020)), directional_light({1, 2, 3}, rgb(0xCCCCCC), 1.3_scaled), point_light({1, 1, 2}, rgb(0x777777))};
constexpr Scene gray_scene{.lights = gray_lamps, .objects = gray_objects};

template <class Tier>
void expect_luma_of_greys() {
    Workspace<gray_scene, Tier> colors;
    Workspace<gray_scene, Tier, VertexStore::keep, usual_slots, Channels::luma> grays;
    Renderer<gray_scene, Tier> in_rgb(colors);
    Renderer<gray_scene, Tier, VertexStore::keep, needs_of(gray_scene), Channels::luma> in_luma(grays);
    in_rgb.begin({}, {64, 64}), in_luma.begin({}, {64, 64});
    for (uint32_t o = 0; o < 2; ++o)
        for (uint32_t v = 0; v < gray_objects[o].mesh.positions.count; ++v) EXPECT_EQ(in_luma.lit_vertex(o, v).luma, in_rgb.lit_vertex(o, v).g);
    static_assert(sizeof(grays) < sizeof(colors));
}
TEST(Luma, OfASceneOfGreysIsAnyOfItsChannels) {
    expect_luma_of_greys<lowp>();
    expect_luma_of_greys<mediump>();
    expect_luma_of_greys<highp>();
}

// Red four times too bright: each channel alone would end at 0.299.
constexpr Object red_quad[] = {{.mesh = quad.mesh(), .material = {.diffuse = rgb(0xFF0000)}}};
constexpr Light bright[] = {directional_light({0, 0, 1}, white, 2.5_scaled)};
constexpr Scene red_scene{.lights = bright, .objects = red_quad};
TEST(Luma, IsSaturatedItselfRatherThanItsChannels) {
    Workspace<red_scene, highp, VertexStore::keep, usual_slots, Channels::luma> memory;
    Renderer<red_scene, highp, VertexStore::keep, needs_of(red_scene), Channels::luma> renderer(memory);
    renderer.begin({}, {64, 64});
    EXPECT_NEAR(renderer.lit_vertex(0, 0).luma / 16777216.0, 2.5 * LumaWeights::red / 65536, 1e-6);
}

// A cube as a display of one bit shows it, 13 pixels wide.
constexpr Object lone_cube[] = {{.mesh = cube.mesh(), .material = {.diffuse = white, .shading = Shading::flat}, .pose = {.rotation = rotate_y(35_deg)}}};
constexpr Light side[] = {ambient_light(rgb(0x202020)), directional_light({3, 0, 2}, white, 0.85_scaled)};
constexpr Scene cube_scene{.camera = {.eye = {0, 0, 4}, .fov_y = 46_deg}, .lights = side, .objects = lone_cube};
TEST(Mono1, IsReadableWhenDithered) {
    using Format = Dithered<Mono1, bayer4>;
    Workspace<cube_scene, mediump, VertexStore::keep, usual_slots, Channels::luma> memory;
    Renderer<cube_scene, mediump, VertexStore::keep, needs_of(cube_scene), Channels::luma> renderer(memory);
    Framebuffer<Format, 13, 9> frame;
    renderer.begin({}, {13, 9});
    renderer.draw(frame.band());
    std::string art = "\n";
    for (int32_t y = 0; y < 9; ++y) {
        for (int32_t x = 0; x < 13; ++x) art += luma_code<Format>(frame.band().row(y), x) != 0 ? '#' : '.';
        art += '\n';
    }
    EXPECT_EQ(art, R"(
.....#.......
.....#####...
.....#####...
....######...
.....###.#...
.....#####...
.....#####...
....######...
.....#.......
)");
}

// A smooth ramp: an eye, or a mean of 8 x 8 pixels, sees the codes between through dithering, and bands without it.
constexpr Rgb ramp_colors[] = {rgb(0x203040), rgb(0x485868), rgb(0x485868), rgb(0x203040)};
constexpr Mesh ramp_mesh() {
    Mesh mesh = quad.mesh();
    mesh.colors = ramp_colors;
    return mesh;
}
constexpr Object ramp[] = {{.mesh = ramp_mesh(), .material = {.diffuse = white, .unlit = true}, .pose = {.scale = {4, 4, 4}}}};
constexpr Scene ramp_scene{.camera = {.eye = {0, 0, 4}}, .objects = ramp};

template <class Format>
double low_pass_error() {
    constexpr int32_t size = 96;
    const auto frame = []<class F>(F) {
        Workspace<ramp_scene, mediump> memory;
        Renderer<ramp_scene, mediump> renderer(memory);
        auto target = std::make_unique<Framebuffer<F, size, size>>();
        renderer.begin({}, {size, size});
        renderer.draw(target->band());
        return std::vector<typename F::Pixel>(target->pixels, target->pixels + size * size);
    };
    const auto exact = frame(host::UnroundedExact565{});
    const auto shown = frame(Format{});
    double squares = 0;
    for (int32_t top = 0; top + 8 <= size; ++top)
        for (int32_t left = 0; left + 8 <= size; ++left) {
            double sum = 0;  // of green, in codes
            for (int32_t y = top; y < top + 8; ++y)
                for (int32_t x = left; x < left + 8; ++x) {
                    const auto i = static_cast<std::size_t>(y * size + x);
                    sum += (shown[i] >> 5 & 63) - (exact[i].g / 16777216.0 - 0.5);
                }
            squares += sum / 64 * sum / 64;
        }
    return std::sqrt(squares / ((size - 7) * (size - 7)));
}
TEST(Dithered, ARampHasNoBands) {
    const double banded = low_pass_error<Rgb565>(), coarse = low_pass_error<Dithered<Rgb565, bayer4>>(), fine = low_pass_error<Dithered<Rgb565, bayer8>>();
    EXPECT_GT(banded, 0.15);  // of a code; rounding errors of a wide band do not cancel
    EXPECT_LT(coarse, banded / 6);
    EXPECT_LT(fine, banded / 6);
}

}  // namespace
}  // namespace shade16
