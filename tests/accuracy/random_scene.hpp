// A random scene of the terms that it may use, and of no others: shapes, materials, maps and lights of every kind.
#pragma once

#include <algorithm>
#include <deque>
#include <vector>

#include "host_sim/bounds/random_surface.hpp"

namespace shade16::host {

class RandomScene {
public:
    RandomScene(Random& random, const Needs& may) : random_(random), may_(may) {
        choose_camera();
        choose_lights();
        const int objects = may.depth ? random.integer(1, 3) : 1;
        for (int i = 0; i < objects; ++i) add_object();
        scene_.lights = {lights_.data(), static_cast<uint32_t>(lights_.size())};
        scene_.objects = {objects_.data(), static_cast<uint32_t>(objects_.size())};
        scene_.background = random.color();
    }
    RandomScene(const RandomScene&) = delete;
    RandomScene& operator=(const RandomScene&) = delete;

    const Scene& scene() const { return scene_; }

private:
    bool maybe(bool allowed) { return allowed && random_.coin(); }
    Angle any_angle() { return {static_cast<uint32_t>(random_.uniform(0, 4294967295.0))}; }

    void choose_camera() {
        Camera& c = scene_.camera;
        c.eye = vec3(random_.direction() * random_.uniform(3.5, 6));
        c.fov_y = Angle{static_cast<uint32_t>(random_.uniform(30, 60) / 360 * 4294967296.0)};
        c.near_distance = q16(random_.uniform(0.5, 1.2));
        c.far_distance = 20;
        c.view_height = q16(random_.uniform(2.5, 4));
        c.projection = may_.perspective && (!may_.orthographic || random_.coin()) ? Projection::perspective : Projection::orthographic;
        c.viewer = maybe(may_.local_viewer) ? Viewer::local : Viewer::infinite;
    }

    void choose_lights() {
        if (maybe(may_.ambient)) lights_.push_back(ambient_light(random_.color()));
        const bool has_lamps = may_.point && (!may_.directional || random_.integer(0, 2) > 0);
        const int count = may_.directional || may_.point ? random_.integer(1, 3) : 0;
        for (int i = 0; i < count; ++i) {
            const bool lamp = has_lamps && (!may_.directional || random_.coin());
            Light light = lamp ? random_lamp() : directional_light(vec3(random_.direction() * random_.log_uniform(0.5, 50)), random_.color());
            light.space = static_cast<Space>(random_.integer(0, 2));
            light.intensity = Scaled::normalized(static_cast<uint64_t>(random_.log_uniform(0.1, 1.5) * 65536), -16);
            if (!may_.diffuse) light.diffuse = black;
            if (!may_.specular) light.specular = black;
            lights_.push_back(light);
        }
    }
    Light random_lamp() {
        Light light = point_light(vec3(random_.direction() * random_.uniform(1.5, 5)), random_.color());
        if (maybe(may_.attenuation)) light.attenuation = {1, q16(random_.uniform(0, 0.2)), q16(random_.uniform(0, 0.1))};
        if (maybe(may_.falloff)) light.attenuation.power = q16(random_.uniform(0.2, 1.8));
        if (maybe(may_.range)) light.range = q16(random_.uniform(3, 8));
        if (!maybe(may_.spot)) return light;
        light.kind = LightKind::spot;
        const double outer = random_.uniform(15, 60);
        const auto degrees = [](double d) { return Angle{static_cast<uint32_t>(d / 360 * 4294967296.0)}; };
        light.spot = {vec3(-reference::value(light.position)), degrees(outer * random_.uniform(0.2, 0.9)), degrees(outer), 0};
        if (maybe(may_.spot_exponent)) light.spot.exponent = q16(random_.uniform(1, 20));
        return light;
    }

    void add_object() {
        Object o;
        o.material = random_material();
        o.mesh = random_mesh(o.material);
        o.material.diffuse = may_.diffuse || o.material.unlit ? o.material.diffuse : black;
        o.pose.rotation = rotate_x(any_angle()) * rotate_y(any_angle()) * rotate_z(any_angle());
        const Q16 s = q16(random_.uniform(0.5, 1));
        o.pose.scale = maybe(may_.stretch) ? Vec3{s, q16(random_.uniform(0.4, 1)), q16(random_.uniform(0.4, 1))} : Vec3{s, s, s};
        if (may_.depth) o.pose.translation = vec3(random_.direction() * random_.uniform(0, 0.9));
        objects_.push_back(o);
    }

    Material random_material() {
        Material m;
        m.unlit = may_.unlit && may_.gouraud && (!may_.lit || random_.integer(0, 4) == 0);
        std::vector<Shading> shadings;
        if (may_.flat) shadings.push_back(Shading::flat);
        if (may_.gouraud) shadings.push_back(Shading::gouraud);
        if (may_.phong) shadings.push_back(Shading::phong);
        m.shading = shadings[static_cast<std::size_t>(random_.integer(0, static_cast<int>(shadings.size()) - 1))];
        m.normal_path = maybe(may_.spherical) ? NormalPath::spherical : NormalPath::linear;
        m.diffuse = random_.color();
        m.ambient = may_.ambient ? random_.color() : black;
        if (maybe(may_.ambient)) m.emissive = Rgb{Unorm16::from_raw(6000), Unorm16::from_raw(3000), {}};
        if (may_.specular && (may_.halfway || may_.reflected)) m.specular = random_.color();
        m.reflection = may_.reflected && (!may_.halfway || random_.coin()) ? Reflection::phong : Reflection::blinn_phong;
        m.shininess = q16(random_.log_uniform(1, 128));
        choose_maps(m);
        return m;
    }
    void choose_maps(Material& m) {
        if (may_.light_table && random_.integer(0, 3) == 0) {
            m.light_table = maybe(may_.bilinear) ? LightTable::bilinear : LightTable::nearest;
            return;
        }
        if (maybe(may_.texture)) m.texture = &texture();
        if (maybe(may_.bump)) m.bump = &relief();
        m.filter = maybe(may_.bilinear) ? Filter::bilinear : Filter::nearest;
        m.mapping = maybe(may_.perspective_texture) ? Mapping::perspective : Mapping::affine;
    }

    Mesh random_mesh(const Material& m) {
        const bool textured = m.texture != nullptr || m.bump != nullptr;
        Mesh mesh = textured ? textured_cube.mesh() : cube.mesh();
        const bool convex_alone = !may_.depth;  // without a depth buffer one convex shape
        if (!convex_alone) {
            const int kind = random_.integer(0, 2);
            if (kind == 1) mesh = textured ? textured_sphere<16, 8>.mesh() : sphere<16, 8>.mesh();
            if (kind == 2) mesh = textured ? textured_torus<16, 8>.mesh() : torus<16, 8>.mesh();
        }
        if (may_.vertex_colors && random_.integer(0, 2) == 0) {
            auto& colors = colors_.emplace_back();
            for (uint32_t i = 0; i < mesh.positions.count; ++i) colors.push_back(random_.color());
            mesh.colors = {colors.data(), static_cast<uint32_t>(colors.size())};
        }
        return mesh;
    }

    const Texture& texture() {
        auto& texels = texels_.emplace_back();
        for (int i = 0; i < 256; ++i) texels.push_back(static_cast<uint16_t>(random_.integer(0, 65535)));
        return textures_.emplace_back(Texture{{texels.data(), 256}, 5, 3});
    }
    const SlopeMap& relief() {
        auto& slopes = slopes_.emplace_back();
        for (int i = 0; i < 64; ++i) slopes.push_back({static_cast<int8_t>(random_.integer(-100, 100)), static_cast<int8_t>(random_.integer(-100, 100))});
        return reliefs_.emplace_back(SlopeMap{{slopes.data(), 64}, 3, 3, 8});
    }

    Random& random_;
    const Needs may_;
    std::vector<Light> lights_{};
    std::vector<Object> objects_{};
    std::deque<std::vector<Rgb>> colors_{};  // deques: the scene points into them
    std::deque<std::vector<uint16_t>> texels_{};
    std::deque<std::vector<Slope8>> slopes_{};
    std::deque<Texture> textures_{};
    std::deque<SlopeMap> reliefs_{};
    Scene scene_{};
};

}  // namespace shade16::host
