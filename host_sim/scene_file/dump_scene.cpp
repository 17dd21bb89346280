#include "host_sim/scene_file/dump_scene.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "host_sim/scene_file/decimal.hpp"

namespace shade16::host {

namespace {

constexpr char axis_letters[] = "xyz";

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
            result += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        } else {
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result + '"';
}

std::string list(Vec3 v) { return fmt::format("[{}, {}, {}]", decimal(v.x), decimal(v.y), decimal(v.z)); }
std::string list(Rgb c) { return fmt::format("[{}, {}, {}]", decimal(c.r), decimal(c.g), decimal(c.b)); }

std::string list(const std::vector<Rgb>& colors) {
    std::string text = "[";
    for (const Rgb& c : colors) text += (text.size() == 1 ? "" : ", ") + list(c);
    return text + "]";
}

class Dump {
public:
    void table(const std::string& heading) { text_ += (text_.empty() ? "" : "\n") + heading + "\n"; }
    void key(const char* name, const std::string& value) { text_ += fmt::format("{} = {}\n", name, value); }
    void word(const char* name, const std::string& value) { key(name, quoted(value)); }
    std::string text() && { return std::move(text_); }

private:
    std::string text_{};
};

void add_output(Dump& to, const OutputSettings& o) {
    to.table("[output]");
    to.key("size", fmt::format("[{}, {}]", o.size.width, o.size.height));
    to.word("format", o.target.format);
    if (o.target.dither != dither_names[0]) to.word("dither", o.target.dither);
    to.word("tier", o.tier);
    if (o.frames > 0) to.key("frames", std::to_string(o.frames));
    to.key("fps", std::to_string(o.fps));
    if (o.band_rows > 0) to.key("bands", std::to_string(o.band_rows));
}

void add_camera(Dump& to, const Camera& c) {
    to.table("[camera]");
    to.key("eye", list(c.eye));
    to.key("target", list(c.target));
    to.key("up", list(c.up));
    to.word("projection", c.projection == Projection::perspective ? "perspective" : "orthographic");
    to.word("viewer", c.viewer == Viewer::infinite ? "infinite" : "local");
    to.key("fov", decimal_degrees(c.fov_y));
    to.key("view_height", decimal(c.view_height));
    to.key("near", decimal(c.near_distance));
    to.key("far", decimal(c.far_distance));
}

void add_light(Dump& to, const Light& l) {
    const char* const spaces[] = {"world", "view", "object"};
    const char* const kinds[] = {"ambient", "directional", "point", "spot"};
    to.table("[[lights]]");
    to.word("kind", kinds[static_cast<std::size_t>(l.kind)]);
    to.key(l.kind == LightKind::ambient ? "color" : "diffuse", list(l.diffuse));
    to.key("intensity", decimal(l.intensity));
    if (l.kind == LightKind::ambient) return;
    to.key("specular", list(l.specular));
    to.key(l.is_lamp() ? "position" : "direction", list(l.position));
    to.word("space", spaces[static_cast<std::size_t>(l.space)]);
    if (l.is_lamp()) {
        const Attenuation& a = l.attenuation;
        to.key("attenuation", fmt::format("{{ constant = {}, linear = {}, quadratic = {}, power = {} }}",
                                          decimal(a.constant), decimal(a.linear), decimal(a.quadratic),
                                          decimal(a.power)));
        to.key("range", decimal(l.range));
    }
    if (l.kind == LightKind::spot) {
        to.key("direction", list(l.spot.direction));
        to.key("inner", decimal_degrees(l.spot.inner));
        to.key("outer", decimal_degrees(l.spot.outer));
        to.key("exponent", decimal(l.spot.exponent));
    }
}

void add_material(Dump& to, const MaterialDescription& d) {
    const Material& m = d.material;
    to.table(fmt::format("[materials.{}]", quoted(d.name)));
    if (m.ambient.given) to.key("ambient", list(m.ambient.color));
    to.key("diffuse", list(m.diffuse));
    to.key("specular", list(m.specular));
    to.key("emissive", list(m.emissive));
    to.key("shininess", decimal(m.shininess));
    to.word("reflection", m.reflection == Reflection::phong ? "phong" : "blinn_phong");
    to.word("shading", m.shading == Shading::flat ? "flat" : m.shading == Shading::phong ? "phong" : "gouraud");
    to.word("normals", m.normal_path == NormalPath::spherical ? "spherical" : "linear");
    constexpr const char* tables[] = {"none", "nearest", "bilinear"};
    to.word("light_table", tables[static_cast<std::size_t>(m.light_table)]);
    const auto picture = [&](const char* key, const std::string& path) {
        to.word(key, std::filesystem::absolute(path).lexically_normal().string());
    };
    if (d.maps.texture) picture("texture", d.maps.texture->path);
    if (d.maps.bump) picture("bump", d.maps.bump->path);
    if (d.maps.bump) to.key("bump_strength", fmt::format("{}", d.maps.bump->strength));
    to.word("filter", m.filter == Filter::bilinear ? "bilinear" : "nearest");
    to.word("mapping", m.mapping == Mapping::perspective ? "perspective" : "affine");
    if (m.alpha.raw != Unorm16::one) to.key("alpha", decimal(m.alpha));
    to.key("unlit", m.unlit ? "true" : "false");
}

void add_mesh(Dump& to, const MeshDescription& m, const std::string& scene_path) {
    const bool sphere = m.kind == ShapeKind::sphere, torus = m.kind == ShapeKind::torus;
    to.table(fmt::format("[meshes.{}]", quoted(m.name)));
    if (m.kind == ShapeKind::file) {
        const auto beside = std::filesystem::path(scene_path).parent_path() / m.file;
        to.word("file", std::filesystem::absolute(beside).lexically_normal().string());
        if (m.crease_degrees) to.key("crease", decimal(*m.crease_degrees));
        return;
    }
    to.word("shape", sphere ? "sphere" : torus ? "torus" : m.kind == ShapeKind::cube ? "cube" : "quad");
    if (sphere || torus) {
        to.key(sphere ? "slices" : "rings", std::to_string(m.around));
        to.key(sphere ? "stacks" : "sides", std::to_string(m.along));
    }
    if (torus) to.key("minor_radius", decimal(m.minor_radius));
    if (!m.colors.empty()) to.key("colors", list(m.colors));
}

void add_object(Dump& to, const ObjectDescription& o) {
    to.table("[[objects]]");
    to.word("mesh", o.mesh);
    if (!o.material.empty()) to.word("material", o.material);
    const auto& d = o.rotation.degrees;
    to.key("rotation", fmt::format("[{}, {}, {}]", decimal(d[0]), decimal(d[1]), decimal(d[2])));
    to.word("order", o.rotation.order);
    to.key("scale", list(o.scale));
    to.key("translation", list(o.translation));
    to.key("spin", fmt::format("{{ turns = {}, axis = \"{}\" }}", decimal(o.spin.turns),
                               axis_letters[static_cast<std::size_t>(o.spin.axis)]));
    to.key("centred", o.centred ? "true" : "false");
    if (o.convex) to.key("convex", *o.convex ? "true" : "false");
}

}  // namespace

std::string dump_scene(const SceneDescription& scene) {
    Dump to;
    to.key("background", list(scene.background));
    add_output(to, scene.output);
    add_camera(to, scene.camera);
    for (const Light& light : scene.lights) add_light(to, light);
    for (const MaterialDescription& material : scene.materials) add_material(to, material);
    for (const MeshDescription& mesh : scene.meshes) add_mesh(to, mesh, scene.path);
    for (const ObjectDescription& object : scene.objects) add_object(to, object);
    return std::move(to).text();
}

}  // namespace shade16::host
