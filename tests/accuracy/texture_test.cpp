// Where textures are looked up: every texel says its own place, so that a frame shows the coordinates of its pixels.
#include <cstdio>

#include <gtest/gtest.h>

#include "host_sim/bounds/random_surface.hpp"
#include "host_sim/reference/texture.hpp"

namespace shade16::host {
namespace {

/// 256 x 256 texels; texel (x, y) is the code y * 256 + x, which an unlit white surface shows unchanged.
const Texture& addresses() {
    static const std::vector<uint16_t> texels = [] {
        std::vector<uint16_t> all(65536);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<uint16_t>(i);
        return all;
    }();
    static const Texture texture{{texels.data(), static_cast<uint32_t>(texels.size())}, 8, 8};
    return texture;
}

/// One triangle, seen from anywhere.
struct RandomTriangle {
    Position16 positions[3]{};
    TexCoord16 texcoords[3]{};
    const Triangle face[1] = {{0, 1, 2}};
    Object object{};
    Scene scene{};

    RandomTriangle(Random& random, Mapping mapping, int texcoord_bits) {
        for (Position16& p : positions) {
            const auto coordinate = [&] { return static_cast<int16_t>(random.integer(-32767, 32767)); };
            p = {coordinate(), coordinate(), coordinate()};
        }
        for (TexCoord16& t : texcoords) {
            const auto coordinate = [&] { return static_cast<int16_t>(random.integer(-32768, 32767)); };
            t = {coordinate(), coordinate()};
        }
        object.mesh = {.positions = positions, .texcoords = texcoords, .triangles = face, .fraction_bits = 14, .texcoord_bits = static_cast<int8_t>(texcoord_bits)};
        object.material.unlit = true, object.material.diffuse = white;
        object.material.texture = &addresses(), object.material.mapping = mapping;
        scene.camera.eye = vec3(random.direction() * random.log_uniform(2.2, 6));
        scene.camera.near_distance = Q16::from_raw(random.coin() ? 655 : 65536);
        scene.camera.projection = random.integer(0, 4) == 0 ? Projection::orthographic : Projection::perspective;
        scene.objects = {&object, 1};
    }
    RandomTriangle(const RandomTriangle&) = delete;
};

/// How far coordinates are outside of the texel that was shown, in texels.
double distance_outside(double coordinate, int texel) {
    double d = std::fmod(coordinate - texel - 0.5, 256);
    if (d > 128) d -= 256;
    if (d < -128) d += 256;
    return std::max(std::abs(d) - 0.5, 0.0);
}

struct Shown {
    double worst = 0;
    std::size_t pixels = 0, other_texel = 0;
};

void look(Shown& shown, RandomTriangle& t, Viewport frame_size) {
    RuntimeRenderer<mediump> renderer(t.scene);
    renderer.begin({}, frame_size);
    const auto pixels = renderer.draw<Rgb565>();
    std::array<glm::dvec2, 3> corner_px, at;
    glm::dvec3 depth;
    const reference::View view = reference::make_view(t.scene.camera, frame_size);
    const reference::Mesh mesh = reference::value(t.object.mesh);
    for (uint32_t k = 0; k < 3; ++k) {
        const auto v = renderer.lit_vertex(0, k);
        if (v.flags & outside_any) return;  // clipped: its corners are elsewhere
        corner_px[k] = {frame_size.width / 2.0 + v.x / 16.0, frame_size.height / 2.0 + v.y / 16.0};
        at[k] = mesh.texcoords[k];
        depth[static_cast<int>(k)] = -reference::to_view(view, mesh.positions[k]).z;
    }
    const glm::dvec2 b = corner_px[1] - corner_px[0], c = corner_px[2] - corner_px[0];
    if (b.x * c.y - b.y * c.x >= 0) return;  // facing away
    const bool by_depth = view.perspective && t.object.material.mapping == Mapping::perspective;
    for (int y = 0; y < frame_size.height; ++y)
        for (int x = 0; x < frame_size.width; ++x) {
            const glm::dvec3 w = reference::barycentric(corner_px, {x + 0.5, y + 0.5});
            if (!(w.x > 1e-6 && w.y > 1e-6 && w.z > 1e-6)) continue;  // on the edge, the top-left rule decides
            const uint16_t texel = pixels[static_cast<std::size_t>(y * frame_size.width + x)];
            const glm::dvec2 place = 256.0 * reference::texture_coordinates(at, {w, corner_px, w / depth, false, {}}, by_depth);
            const double outside = std::max(distance_outside(place.x, texel & 255), distance_outside(place.y, texel >> 8));
            shown.worst = std::max(shown.worst, outside);
            shown.other_texel += outside > 0;
            ++shown.pixels;
        }
}

Shown look_at_many(uint64_t seed, Mapping mapping, int texcoord_bits, Viewport frame_size, int triangles) {
    Random random(seed);
    Shown shown;
    for (int i = 0; i < triangles; ++i) {
        RandomTriangle t(random, mapping, texcoord_bits);
        look(shown, t, frame_size);
    }
    return shown;
}

/// In texels of 256 a side.
double bound(Mapping mapping, int texcoord_bits, Viewport frame_size) {
    const int log2 = mapping == Mapping::affine ? affine_coordinates_max_error_log2 : perspective_coordinates_max_error_log2;
    return std::ldexp(std::max(1.0, frame_size.width / 256.0), 8 + 15 - texcoord_bits + log2);
}

class Coordinates : public testing::TestWithParam<std::tuple<Mapping, int>> {
protected:
    static void expect_held(uint64_t seed, Viewport frame_size, int triangles) {
        const auto [mapping, bits] = GetParam();
        const Shown shown = look_at_many(seed, mapping, bits, frame_size, triangles);
        EXPECT_GT(shown.pixels, 300'000u);
        EXPECT_LE(shown.worst, bound(mapping, bits, frame_size));
        EXPECT_GT(shown.other_texel, 0u) << "no pixel is near the edge of a texel: the bound is not tried";
        std::printf("[ texture  ] %-11s %2d bits, %4d px: at most %.6f texel off, %.2f of the bound; %.4f %% of %zu pixels show a neighbour\n",
                    mapping == Mapping::affine ? "affine" : "perspective", bits, frame_size.width, shown.worst, shown.worst / bound(mapping, bits, frame_size),
                    100.0 * static_cast<double>(shown.other_texel) / static_cast<double>(shown.pixels), shown.pixels);
    }
};

TEST_P(Coordinates, StayInsideTheirBound) { expect_held(11, {160, 120}, 1500); }
TEST_P(Coordinates, StayInsideTheirBoundInLargeFrames) { expect_held(13, {1024, 1024}, 60); }
INSTANTIATE_TEST_SUITE_P(, Coordinates, testing::Combine(testing::Values(Mapping::affine, Mapping::perspective), testing::Values(15, 14, 11)));

// What a test of coordinates would not see if both mappings were the same.
TEST(Mappings, Differ) {
    Random random(12);
    std::size_t differing = 0, pixels = 0;
    for (int i = 0; i < 50; ++i) {
        RandomTriangle t(random, Mapping::affine, 14);
        RuntimeRenderer<mediump> renderer(t.scene);
        renderer.begin({}, {160, 120});
        const auto affine = renderer.draw<Rgb565>();
        t.object.material.mapping = Mapping::perspective;
        const auto perspective = renderer.draw<Rgb565>();
        for (std::size_t k = 0; k < affine.size(); ++k) differing += affine[k] != perspective[k], pixels += affine[k] != 0;
    }
    EXPECT_GT(differing, pixels / 4);
}

}  // namespace
}  // namespace shade16::host
