// One point of one object under some lights: what the tests of light look at.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "shade16/pipeline/light.hpp"

namespace shade16 {

inline constexpr Material shiny{.diffuse = rgb(0xC08040), .specular = rgb(0x80C0FF), .shininess = 20};
inline constexpr Normal14 facing{{}, {}, {16384}};
inline constexpr Normal14 averted{{}, {}, {-16384}};

struct Setting {
    Camera camera{};
    Material material = shiny;
    std::vector<Light> lights{};
    Pose pose{};
    Mesh mesh{};
    const Rgb* color = nullptr;
    Component component = Component::all;
};

template <class Tier>
Accumulator lit(const Setting& s, Normal14 normal = facing, Position16 position = {}) {
    const Mat3 view = look_rotation(s.camera);
    const View<Light> lights{s.lights.data(), static_cast<uint32_t>(s.lights.size())};
    auto object = make_object_lighting<Tier>(s.camera, view, lights, s.material, s.pose, s.mesh);
    std::vector<ObjectLight<Tier>> object_lights;
    std::vector<LampShape> shapes(s.lights.size());
    object.shapes = shapes.data();
    keep_component(object, s.component);
    for (const Light& light : s.lights) {
        if (light.kind == LightKind::ambient) continue;
        object_lights.push_back(make_object_light<Tier>(s.camera, view, light, s.material, s.pose, s.mesh));
        ObjectLight<Tier>& last = object_lights.back();
        keep_component(last, s.component);
        if (!detail::is_shaped(light)) continue;
        last.shape = static_cast<uint16_t>(object_lights.size());
        shapes[object_lights.size() - 1] = make_lamp_shape(view, light, s.pose, s.mesh, last.point.bits);
    }
    const Shininess<Tier> kernel = shininess<Tier>(s.material.shininess);
    const bool has_specular = s.material.specular != black;
    ColorFactor factor{};
    if (s.color != nullptr) factor = *s.color;
    return light_point<all_needs, Tier>(object, {object_lights.data(), static_cast<uint32_t>(object_lights.size())}, has_specular ? &kernel : nullptr,
                                        {raw(position), 1}, lighting_normal<all_needs, Tier>(object, normal), s.color != nullptr ? &factor : nullptr);
}

inline ::testing::AssertionResult is_black(const Accumulator& sum) {
    if ((sum.r | sum.g | sum.b) == 0) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << sum.r << ' ' << sum.g << ' ' << sum.b;
}
inline ::testing::AssertionResult are_equal(const Accumulator& a, const Accumulator& b) {
    if (a.r == b.r && a.g == b.g && a.b == b.b) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << a.r << ' ' << a.g << ' ' << a.b << " and " << b.r << ' ' << b.g << ' ' << b.b;
}

}  // namespace shade16
