#include "tests/fuzz/byte_scene.hpp"

namespace shade16::fuzz {

ByteScene::ByteScene(Bytes bytes) : f_(bytes) {
    choose_target();
    scene_.camera = camera();
    scene_.background = f_.color();
    lights_ = lights(f_.is_extreme() ? f_.below(65) : f_.below(5));
    for (uint32_t count = f_.is_extreme() ? f_.below(9) : 1 + f_.below(3); count > 0; --count) objects_.push_back(object());
    scene_.lights = {lights_.data(), static_cast<uint32_t>(lights_.size())};
    scene_.objects = {objects_.data(), static_cast<uint32_t>(objects_.size())};
    choose_frame();
    drawing_.scene = &scene_, drawing_.frame = &frame_;
}

void ByteScene::choose_target() {
    drawing_.target = f_.below(target_count);
    drawing_.viewport = {static_cast<int32_t>(1 + f_.below(48)), static_cast<int32_t>(1 + f_.below(32))};
    drawing_.band_rows = static_cast<int32_t>(1 + f_.below(static_cast<uint32_t>(drawing_.viewport.height)));
}

Camera ByteScene::camera() {
    Camera c;
    c.eye = f_.vec3(-2'500, 2'500);
    c.eye.z = f_.q16(1'500, 5'000);
    c.target = f_.vec3(-400, 400);
    c.up = f_.vec3(-1'000, 1'000);
    c.projection = f_.one_of<Projection>(2);
    c.viewer = f_.one_of<Viewer>(2);
    c.fov_y = f_.is_extreme() ? f_.any_turn() : 20_deg + f_.angle();
    c.view_height = f_.q16(1'000, 5'000);
    c.near_distance = f_.q16(100, 2'500);
    c.far_distance = f_.q16(3'000, 50'000);
    return c;
}

Light ByteScene::light() {
    Light l;
    l.kind = f_.one_of<LightKind>(4);
    l.space = f_.one_of<Space>(3);
    l.position = f_.vec3(-5'000, 5'000);
    l.diffuse = f_.color();
    l.specular = f_.color();
    l.intensity = f_.intensity();
    if (f_.one_in(2)) l.attenuation = {f_.q16(0, 2'000), f_.q16(0, 500), f_.q16(0, 500), 0};
    if (f_.one_in(3)) l.attenuation.power = f_.q16(0, 2'000);
    if (f_.one_in(3)) l.range = f_.q16(0, 12'000);
    if (l.kind == LightKind::spot) {
        l.spot.direction = f_.one_in(2) ? f_.vec3(-1'000, 1'000) : -l.position;
        l.spot.inner = f_.angle(), l.spot.outer = f_.angle();
        if (f_.one_in(2)) l.spot.exponent = f_.q16(0, 128'000);
    }
    return l;
}

std::vector<Light> ByteScene::lights(std::size_t count) {
    std::vector<Light> all;
    while (all.size() < count) all.push_back(light());
    return all;
}

Material ByteScene::material() {
    Material m;
    if (f_.one_in(2)) m.ambient = f_.color();
    m.diffuse = f_.color();
    m.specular = f_.color();
    if (f_.one_in(4)) m.emissive = f_.color();
    m.shininess = f_.q16(1'000, 200'000);
    m.reflection = f_.one_of<Reflection>(2);
    m.shading = f_.one_of<Shading>(3);
    m.normal_path = f_.one_of<NormalPath>(2);
    if (f_.one_in(8)) m.light_table = f_.one_of<LightTable>(3);
    m.filter = f_.one_of<Filter>(2);
    m.mapping = f_.one_of<Mapping>(2);
    m.alpha = Unorm16::from_raw(f_.u16());
    m.unlit = f_.one_in(8);
    return m;
}

void ByteScene::choose_maps(Material& m) {
    if (maps_.empty() || f_.one_in(2)) maps_.emplace_back(f_);
    if (f_.one_in(2)) m.texture = &maps_.back().texture();
    if (f_.one_in(2)) m.bump = &maps_.back().relief();
}

Pose ByteScene::pose() {
    Pose p;
    p.rotation = f_.rotation();
    const Q16 size = f_.q16(300, 1'500);
    p.scale = {size, size, size};
    if (f_.one_in(3)) p.scale = {size, f_.q16(300, 1'500), f_.q16(300, 1'500)};
    p.translation = f_.vec3(-800, 800);
    return p;
}

Object ByteScene::object() {
    Object o;
    if (meshes_.empty() || !f_.one_in(4)) meshes_.emplace_back(f_);
    o.mesh = meshes_.back().mesh();
    o.material = material();
    if (!o.mesh.texcoords.empty() && f_.one_in(2)) choose_maps(o.material);
    if ((o.material.unlit || o.material.shading == Shading::flat) && f_.one_in(2)) o.mesh.normals = {};  // nobody needs them
    o.pose = pose();
    return o;
}

/// Half of the frames are the scene's own.
void ByteScene::choose_frame() {
    if (!f_.one_in(2)) return;
    if (f_.one_in(2)) other_camera_ = camera(), frame_.camera = &other_camera_;
    if (f_.one_in(3)) other_lights_ = lights(lights_.size()), frame_.lights = other_lights_.data();
    if (f_.one_in(2)) {
        while (other_poses_.size() < objects_.size()) other_poses_.push_back(pose());
        frame_.poses = other_poses_.data();
    }
    if (f_.one_in(3)) {
        for (const Object& o : objects_) {
            Material varied = o.material;
            const Material other = material();
            varied.ambient = other.ambient, varied.diffuse = other.diffuse, varied.specular = other.specular, varied.emissive = other.emissive;
            varied.reflection = other.reflection;
            other_materials_.push_back(varied);
        }
        frame_.materials = other_materials_.data();
    }
    if (f_.one_in(3)) frame_.component = f_.one_of<Component>(4);
}

}  // namespace shade16::fuzz
