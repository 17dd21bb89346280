// Needs: the set of terms that a scene uses, read off its values. A need decides which code exists, never which
// arithmetic runs: a pipeline with more needs draws the same bits.
#pragma once

#include "shade16/scene/scene.hpp"

namespace shade16 {

struct Needs {
    bool perspective = false;    // a divide a vertex
    bool orthographic = false;
    bool depth = false;          // a depth buffer: more than one object, or one that is not convex
    bool lit = false;            // any lit material
    bool unlit = false;          // any unlit material
    bool flat = false;           // faces of one colour
    bool gouraud = false;        // interpolated colours
    bool phong = false;          // light a pixel
    bool spherical = false;      // normals along great circles
    bool light_table = false;    // light by normal, looked up a pixel
    bool vertex_colors = false;  // a factor a vertex
    bool texture = false;        // a look-up a pixel
    bool bilinear = false;       // four look-ups and three mixtures
    bool perspective_texture = false;  // a reciprocal a pixel
    bool bump = false;           // slopes looked up, and a square root more a pixel
    bool ambient = false;        // ambient or emissive light
    bool diffuse = false;
    bool specular = false;       // the chord and the shininess tables
    bool halfway = false;        // Blinn-Phong: a half vector a vertex and light
    bool reflected = false;      // Phong: a mirrored vector a vertex and light
    bool directional = false;
    bool point = false;          // a light vector and a square root a vertex and light
    bool attenuation = false;    // a distance and a divide a vertex and light
    bool falloff = false;        // 1/d^power: a logarithm a vertex and light
    bool range = false;          // a lamp that ends somewhere
    bool spot = false;           // a cone: a fine square root and a chord a vertex and light
    bool spot_exponent = false;  // a logarithm a vertex and spot
    bool local_viewer = false;   // a view vector and a square root a vertex
    bool stretch = false;        // a scale that differs by axis

    friend constexpr bool operator==(const Needs&, const Needs&) = default;
};

namespace detail {
/// The terms as an array, so that nothing below names each of them.
struct NeedsArray {
    static constexpr size_t count = sizeof(Needs);
    bool term[count]{};
};
constexpr NeedsArray as_array(const Needs& n) { return __builtin_bit_cast(NeedsArray, n); }
constexpr Needs as_needs(const NeedsArray& a) { return __builtin_bit_cast(Needs, a); }

consteval Needs every_need() {
    NeedsArray all;
    for (bool& term : all.term) term = true;
    return as_needs(all);
}
}  // namespace detail

inline constexpr Needs all_needs = detail::every_need();

/// The union: one pipeline for several scenes.
constexpr Needs operator|(const Needs& a, const Needs& b) {
    detail::NeedsArray sum = detail::as_array(a);
    const detail::NeedsArray other = detail::as_array(b);
    for (size_t i = 0; i < detail::NeedsArray::count; ++i) sum.term[i] = sum.term[i] || other.term[i];
    return detail::as_needs(sum);
}

/// Whether a pipeline built for `have` can draw what wants `want`.
constexpr bool covers(Needs have, Needs want) { return (have | want) == have; }

namespace detail {
constexpr bool has_texture(const Object& o) { return o.material.texture != nullptr && !o.mesh.texcoords.empty(); }
constexpr bool has_bump(const Object& o) {
    return o.material.bump != nullptr && !o.mesh.texcoords.empty() && is_phong(o.material);
}
/// Whether an object's material asks for the table, and nothing else of its pixels differs but the normal.
constexpr bool may_use_light_table(const Object& o) {
    return o.material.light_table != LightTable::none && is_phong(o.material) && o.mesh.colors.empty() && !has_texture(o) && !has_bump(o);
}

constexpr Needs needs_of_lamp(const Light& lamp) {
    Needs n;
    n.point = true;
    n.attenuation = lamp.attenuation.fades();
    n.falloff = lamp.attenuation.falls_off();
    n.range = lamp.range > Q16{};
    n.spot = lamp.kind == LightKind::spot;
    n.spot_exponent = n.spot && lamp.spot.exponent > Q16{};
    return n;
}
constexpr Needs needs_of(const Object& object, View<Light> lights) {
    const Material& m = object.material;
    Needs n;
    n.unlit = m.unlit;
    n.lit = !m.unlit;
    n.flat = is_flat(m);
    n.phong = is_phong(m);
    n.spherical = n.phong && m.normal_path == NormalPath::spherical;
    n.gouraud = !n.flat && !n.phong && !has_texture(object);  // textured light is interpolated otherwise
    n.vertex_colors = !object.mesh.colors.empty();
    n.stretch = object.pose.scale.x != object.pose.scale.y || object.pose.scale.y != object.pose.scale.z;
    n.texture = has_texture(object);
    n.bump = has_bump(object);
    n.light_table = may_use_light_table(object);
    n.bilinear = ((n.texture || n.bump) && m.filter == Filter::bilinear) || (n.light_table && m.light_table == LightTable::bilinear);
    n.perspective_texture = (n.texture || n.bump) && m.mapping == Mapping::perspective;
    if (m.unlit) return n;

    n.ambient = m.emissive != black;
    for (const Light& light : lights) {
        if (light.intensity.is_zero()) continue;
        if (light.kind == LightKind::ambient) {
            n.ambient |= light.diffuse != black && m.ambient_color() != black;
            continue;
        }
        const bool diffuse = light.diffuse != black && m.diffuse != black;
        const bool specular = light.specular != black && m.specular != black;
        n.diffuse |= diffuse;
        n.specular |= specular;
        n.halfway |= specular && m.reflection == Reflection::blinn_phong;
        n.reflected |= specular && m.reflection == Reflection::phong;
        n.directional |= (diffuse || specular) && light.kind == LightKind::directional;
        if ((diffuse || specular) && light.is_lamp()) n = n | needs_of_lamp(light);
    }
    return n;
}
}  // namespace detail

/// What the scene uses, by looking at its values.
constexpr Needs needs_of(const Scene& scene) {
    Needs n;
    for (const Object& object : scene.objects) n = n | detail::needs_of(object, scene.lights);
    n.perspective = scene.camera.projection == Projection::perspective;
    n.orthographic = !n.perspective;
    n.perspective_texture &= n.perspective;
    n.local_viewer = n.specular && scene.camera.sees_locally();
    n.depth = scene.objects.count > 1 || (scene.objects.count == 1 && !scene.objects[0].mesh.convex);
    return n;
}

}  // namespace shade16
