// Two references written apart, the engine's stages in double precision and a lighting tutorial's two shaders, against
// each other and against the engine: per vertex and per pixel, in all four modes, with both kinds of highlight.
#include <cstdio>

#include <gtest/gtest.h>

#include "host_sim/bounds/random_surface.hpp"
#include "accuracy/textbook_scene.hpp"
#include "host_sim/report/unrounded.hpp"
#include "host_sim/report/winners.hpp"

namespace shade16::host {
namespace {

using textbook::Mode;
constexpr Mode modes[] = {Mode::all, Mode::ambient_only, Mode::diffuse_only, Mode::specular_only};

// Between the references: the textbook takes normals by the inverse transpose of the matrix that it is given, the reference
// takes a pose's rotation for a rotation. Q30 holds one to 7.6e-9 only, unless it is made of quarter turns; there only the
// rounding of doubles is left (3.7e-14 on x86-64).
constexpr double references_max_difference = 1e-13, references_max_difference_turned = 1.8e-8;

/// A scene whose object may be changed: every second one is turned by quarters, every third one has Phong's highlights.
class SceneOf {
public:
    SceneOf(const Scene& scene, int number) : object_(scene.objects[0]), scene_(scene), exact_(number % 2 == 0) {
        const auto quarters = static_cast<uint32_t>(number) / 2;
        if (exact_) object_.pose.rotation = rotate_x(90_deg * quarters) * rotate_y(90_deg * (quarters / 4));
        if (number % 3 == 0) object_.material.reflection = Reflection::phong;
        scene_.objects = {&object_, 1};
    }
    SceneOf(const SceneOf&) = delete;
    const Scene& scene() const { return scene_; }
    const Material& material() const { return object_.material; }
    bool exact() const { return exact_; }

private:
    Object object_;
    Scene scene_;
    bool exact_;
};

/// The frame that shows what a mode shows.
Frame frame_of(Mode mode) {
    switch (mode) {
        case Mode::ambient_only: return {.component = Component::ambient};
        case Mode::diffuse_only: return {.component = Component::diffuse};
        case Mode::specular_only: return {.component = Component::specular};
        default: return {};
    }
}

double largest_levels(const glm::dvec3& difference) {
    const glm::dvec3 d = glm::abs(difference) * levels_of_full_scale;
    return std::max({d.x, d.y, d.z});
}

struct Agreement {
    double references = 0, references_turned = 0, engine = 0, share_of_bound = 0;
    std::size_t count = 0, beside_gate = 0;

    /// Beside the gate N.L = 0 the engine may stand on either side; judge() has looked at both.
    void add(const SceneOf& scene, const glm::dvec3& engine_color, const glm::dvec3& textbook, const reference::LightParts& parts,
             const Verdict& verdict) {
        ++count;
        if (verdict.beside_gate) {
            ++beside_gate;
            share_of_bound = std::max(share_of_bound, verdict.error_levels / verdict.bound_levels);
            return;
        }
        double& difference = scene.exact() ? references : references_turned;
        difference = std::max(difference, largest_levels(textbook - glm::clamp(parts.sum(), 0.0, 1.0)) / levels_of_full_scale);
        const double error = largest_levels(engine_color - textbook);
        engine = std::max(engine, error);
        share_of_bound = std::max(share_of_bound, error / verdict.bound_levels);
    }
    void expect_held(const char* tier, const char* what) const {
        std::printf("[ %-7s  ] %-34s worst %.4f levels, %.3f of its bound; textbook to reference %.1e, turned %.1e; "
                    "%zu points, %zu beside a gate\n",
                    tier, what, engine, share_of_bound, references, references_turned, count, beside_gate);
        EXPECT_LE(references, references_max_difference);
        EXPECT_LE(references_turned, references_max_difference_turned);
        EXPECT_LE(share_of_bound, 1.0);
        EXPECT_GT(engine, 0.0) << "the engine never differs: nothing was compared";
        EXPECT_LT(beside_gate * 200, count) << "too much was left to the gate";
    }
};

template <class Tier>
class Textbook : public testing::Test {
protected:
    static constexpr int bits = ScreenVertex<Tier>::channel_bits;

    static glm::dvec3 color_of(const ScreenVertex<Tier>& v) { return glm::dvec3(v.r, v.g, v.b) * std::ldexp(1.0, -bits); }

    static void add_vertices(Agreement& worst, const Scene& scene, Mode mode, int number) {
        const SceneOf shown(scene, number);
        RuntimeRenderer<Tier> renderer(shown.scene());
        renderer.begin(frame_of(mode), {64, 64});
        const reference::Scene exact = reference::value(shown.scene());
        const TextbookScene tutorial(shown.scene(), {64, 64});
        const textbook::Uniforms uniforms = tutorial.uniforms(0, mode);
        for (uint32_t i = 0; i < scene.objects[0].mesh.positions.count; ++i) {
            const glm::dvec3 engine = color_of(renderer.lit_vertex(0, i));
            const reference::LightParts parts = reference::light_vertex(exact, frame_of(mode), 0, i);
            worst.add(shown, engine, textbook::per_vertex::vertex_shader(uniforms, tutorial.attributes(0, i)).color, parts,
                      judge(engine, parts, shown.material(), promised<Tier>(bits)));
        }
    }
};

using Tiers = testing::Types<lowp, mediump, highp>;
TYPED_TEST_SUITE(Textbook, Tiers);

TYPED_TEST(Textbook, VertexColours) {
    for (const Mode mode : modes) {
        Agreement one, several;
        Random random(31 + static_cast<uint64_t>(mode));
        for (int i = 0; i < 100; ++i) {
            const RandomSurface single(random, {.attenuation = i % 2 == 0, .max_distance = 20});
            const RandomSurface lights(random, {.lights = 3, .stretch = true, .attenuation = i % 2 == 0, .max_distance = 20});
            this->add_vertices(several, lights.scene(), mode, i);
            if (mode != Mode::ambient_only) this->add_vertices(one, single.scene(), mode, i);  // it has no ambient light
        }
        static constexpr const char* names[] = {"all terms", "ambient only", "diffuse only", "specular only"};
        const std::string name = names[static_cast<int>(mode) - 1];
        if (mode != Mode::ambient_only) one.expect_held(TypeParam::name, (name + ", one light").c_str());
        several.expect_held(TypeParam::name, (name + ", three, stretched").c_str());
    }
}

/// A torus, a ball or a box before a camera, in the light of a sun and two lamps.
class RandomView {
public:
    RandomView(Random& random, Shading shading) {
        scene_.camera.eye = vec3(random.direction() * random.uniform(5, 9));
        scene_.camera.target = vec3(random.direction() * 0.3);
        scene_.camera.up = vec3(random.direction());
        scene_.camera.viewer = random.coin() ? Viewer::local : Viewer::infinite;
        if (random.integer(0, 3) == 0) scene_.camera.projection = Projection::orthographic, scene_.camera.view_height = 6;
        lights_[0] = ambient_light(random.color());
        lights_[0].intensity = 0.3_scaled;
        lights_[1] = directional_light(vec3(random.direction() * 3.0), random.color());
        for (Light* lamp : {&lights_[2], &lights_[3]}) {
            *lamp = point_light(vec3(random.direction() * random.uniform(4, 12)), random.color());
            lamp->attenuation = {q16(random.uniform(0.2, 1)), q16(random.uniform(0, 0.1)), q16(random.uniform(0, 0.02))};
            lamp->space = static_cast<Space>(random.integer(0, 2));
        }
        object_.mesh = random.coin() ? torus<24, 12>.mesh() : random.coin() ? sphere<16, 12>.mesh() : cube.mesh();
        const auto angle = [&] { return Angle{static_cast<uint32_t>(random.uniform(0, 4294967295.0))}; };
        const auto scale = [&] { return q16(random.log_uniform(0.6, 1.5)); };
        object_.pose = {rotate_x(angle()) * rotate_y(angle()) * rotate_z(angle()), {scale(), scale(), scale()}, vec3(random.direction() * 0.5)};
        Material& m = object_.material;
        m.diffuse = random.color(), m.specular = random.color(), m.ambient = random.color(), m.shininess = q16(random.log_uniform(1, 128));
        m.shading = shading;
        scene_.lights = lights_;
        scene_.objects = {&object_, 1};
    }
    RandomView(const RandomView&) = delete;
    const Scene& scene() const { return scene_; }

private:
    Light lights_[4];
    Object object_{};
    Scene scene_{};
};

constexpr Viewport viewport{48, 36};

/// Calls f(pixel, face, barycentric weights, the screen's corners) wherever an unclipped face shows.
template <class Tier, class F>
void each_pixel(RuntimeRenderer<Tier>& renderer, const Scene& scene, F f) {
    const std::vector<UnroundedRgb565::Pixel> pixels = renderer.template draw<UnroundedRgb565>();
    const std::vector<FaceId> winners = winning_faces(scene, {}, viewport);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!winners[i].covered) continue;
        const Triangle t = scene.objects[0].mesh.triangles[winners[i].face];
        const std::array<uint32_t, 3> index{t.a, t.b, t.c};
        std::array<glm::dvec2, 3> corner;
        bool clipped = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenVertex<Tier> v = renderer.lit_vertex(0, index[k]);
            corner[k] = {viewport.width / 2.0 + v.x / 16.0, viewport.height / 2.0 + v.y / 16.0};
            clipped = clipped || (v.flags & outside_any) != 0;
        }
        const glm::dvec2 centre(static_cast<double>(i % viewport.width) + 0.5, static_cast<double>(i / viewport.width) + 0.5);
        if (!clipped) f(value(pixels[i]), winners[i].face, index, reference::barycentric(corner, centre), corner);
    }
}

TYPED_TEST(Textbook, PixelsOfPhongShading) {
    for (const Mode mode : modes) {
        Agreement worst;
        Random random(51 + static_cast<uint64_t>(mode));
        for (int i = 0; i < 60; ++i) {
            const RandomView view(random, Shading::phong);
            const SceneOf shown(view.scene(), i);
            RuntimeRenderer<TypeParam> renderer(shown.scene());
            renderer.begin(frame_of(mode), viewport);
            const reference::Scene exact = reference::value(shown.scene());
            const TextbookScene tutorial(shown.scene(), viewport);
            const textbook::Uniforms uniforms = tutorial.uniforms(0, mode);
            each_pixel(renderer, shown.scene(), [&](const glm::dvec3& engine, uint32_t face, const auto& index, const glm::dvec3& weights,
                                                    const auto& corner) {
                const auto out = [&](std::size_t k) { return textbook::per_fragment::vertex_shader(uniforms, tutorial.attributes(0, index[k])); };
                const glm::dvec3 color = textbook::per_fragment::fragment_shader(uniforms, textbook::interpolate(out(0), out(1), out(2), weights));
                const reference::LightParts parts = reference::light_surface(exact, frame_of(mode), 0, face, {weights, corner});
                worst.add(shown, engine, color, parts, judge(engine, parts, shown.material(), promised<TypeParam>(this->bits)));
            });
        }
        static constexpr const char* names[] = {"Phong, all terms", "Phong, ambient only", "Phong, diffuse only", "Phong, specular only"};
        worst.expect_held(TypeParam::name, names[static_cast<int>(mode) - 1]);
    }
}

/// The bound of stepping colours along a row of RGB565, by channel, in levels.
template <class Tier>
glm::dvec3 stepping_bound() {
    const bool packed = Tier::stepping == Stepping::packed;
    const double codes = (packed ? packed_stepping_max_error_per_1024_code : exact_stepping_max_error_per_1024_code) / 1024.0;
    return codes * levels_of_full_scale / glm::dvec3(31, 63, 31);
}

TYPED_TEST(Textbook, PixelsOfGouraudShading) {
    double worst = 0;
    std::size_t count = 0;
    Random random(71);
    for (int i = 0; i < 120; ++i) {
        const RandomView view(random, Shading::gouraud);
        const Mode mode = modes[i / 2 % 4];
        const SceneOf shown(view.scene(), i);
        RuntimeRenderer<TypeParam> renderer(shown.scene());
        renderer.begin(frame_of(mode), viewport);
        const reference::Scene exact = reference::value(shown.scene());
        const TextbookScene tutorial(shown.scene(), viewport);
        const textbook::Uniforms uniforms = tutorial.uniforms(0, mode);
        each_pixel(renderer, shown.scene(), [&](const glm::dvec3& engine, uint32_t, const auto& index, const glm::dvec3& weights, const auto&) {
            double vertex_bound = 0;
            bool beside_gate = false;
            for (const uint32_t corner : index) {
                const reference::LightParts parts = reference::light_vertex(exact, frame_of(mode), 0, corner);
                const Verdict v = judge(this->color_of(renderer.lit_vertex(0, corner)), parts, shown.material(), promised<TypeParam>(this->bits));
                vertex_bound = std::max(vertex_bound, v.bound_levels);
                beside_gate = beside_gate || v.beside_gate;
            }
            if (beside_gate) return;
            const auto out = [&](std::size_t k) { return textbook::per_vertex::vertex_shader(uniforms, tutorial.attributes(0, index[k])); };
            const glm::dvec3 color = textbook::per_vertex::fragment_shader(textbook::interpolate(out(0), out(1), out(2), weights));
            const glm::dvec3 share = glm::abs(engine - color) * levels_of_full_scale / (stepping_bound<TypeParam>() + vertex_bound);
            worst = std::max({worst, share.x, share.y, share.z});
            ++count;
        });
    }
    std::printf("[ %-7s  ] %-34s worst %.3f of its bound, %zu pixels\n", TypeParam::name, "Gouraud, all modes", worst, count);
    EXPECT_LE(worst, 1.0);
    EXPECT_GT(worst, 0.0);
    EXPECT_GT(count, 20'000u);
}

// glm::lookAt and glm::perspective against the reference's own camera, and the engine's snapped positions.
TYPED_TEST(Textbook, PlacesOnTheScreen) {
    double references = 0, engine = 0;
    Random random(81);
    for (int i = 0; i < 100; ++i) {
        const RandomView view(random, Shading::gouraud);
        RuntimeRenderer<TypeParam> renderer(view.scene());
        renderer.begin({}, viewport);
        const TextbookScene tutorial(view.scene(), viewport);
        const textbook::Uniforms uniforms = tutorial.uniforms(0);
        const reference::View camera = reference::make_view(view.scene().camera, viewport);
        const reference::Scene exact = reference::value(view.scene());
        for (uint32_t v = 0; v < exact.meshes[0].positions.size(); ++v) {
            const glm::dvec2 place = tutorial.on_screen(textbook::per_vertex::vertex_shader(uniforms, tutorial.attributes(0, v)).clip_position);
            const glm::dvec3 world = reference::to_world(view.scene().objects[0].pose, exact.meshes[0].positions[v]);
            references = std::max(references, glm::length(place - reference::project(camera, reference::to_view(camera, world)).position));
            const ScreenVertex<TypeParam> lit = renderer.lit_vertex(0, v);
            if (lit.flags & outside_any) continue;
            const glm::dvec2 off = glm::abs(place - glm::dvec2(viewport.width / 2.0 + lit.x / 16.0, viewport.height / 2.0 + lit.y / 16.0));
            engine = std::max({engine, off.x, off.y});
        }
    }
    std::printf("[ %-7s  ] places on the screen: textbook to reference %.1e px, to the engine %.4f px of 1/16\n", TypeParam::name,
                references, engine);
    EXPECT_LE(references, 1e-12);
    EXPECT_LE(engine, 0.5 / 16 * 1.01);  // snapped to the nearest sixteenth
    EXPECT_GT(engine, 0.02);
}

}  // namespace
}  // namespace shade16::host
