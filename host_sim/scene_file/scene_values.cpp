#include "host_sim/scene_file/scene_values.hpp"

#include <fmt/format.h>

#include "host_sim/scene_file/decimal.hpp"

namespace shade16::host {

namespace {

constexpr int nested_columns = 2 * field_columns;

bool is_whole(Q16 x) { return x.raw % 65536 == 0; }
std::string remark(Q16 x) { return is_whole(x) ? "" : decimal(x); }
std::string remark(Vec3 v) {
    if (is_whole(v.x) && is_whole(v.y) && is_whole(v.z)) return {};
    return fmt::format("{}, {}, {}", decimal(v.x), decimal(v.y), decimal(v.z));
}

void add(Fields& to, const char* key, Q16 value, Q16 usual) {
    if (value != usual) to.add(key, literal(value), remark(value));
}
void add(Fields& to, const char* key, const Vec3& value, const Vec3& usual) {
    if (value != usual) to.add(key, literal(value), remark(value));
}
void add(Fields& to, const char* key, Rgb value, Rgb usual) {
    if (value != usual) to.add(key, literal(value));
}

std::string attenuation_text(const Attenuation& a) {
    const std::string power = a.falls_off() ? ", " + literal(a.power) : "";
    return fmt::format("{{{}, {}, {}{}}}", literal(a.constant), literal(a.linear), literal(a.quadratic), power);
}
std::string remark(const Attenuation& a) {
    const std::string text = remark(Vec3{a.constant, a.linear, a.quadratic});
    return is_whole(a.power) ? text : fmt::format("{}{}power {}", text, text.empty() ? "" : "; ", decimal(a.power));
}

std::string spot_text(const Spot& s) {
    const Spot usual{};
    Fields to(nested_columns + field_columns);
    const auto add_angle = [&](const char* key, Angle value, Angle otherwise) {
        if (value != otherwise) to.add(key, fmt::format("{{{}u}}", value.turns), decimal_degrees(value) + " degrees");
    };
    add(to, "direction", s.direction, usual.direction);
    add_angle("inner", s.inner, usual.inner);
    add_angle("outer", s.outer, usual.outer);
    add(to, "exponent", s.exponent, usual.exponent);
    return to.braced();
}

std::string row_text(const Normal30& r) { return fmt::format("{{{{{}}}, {{{}}}, {{{}}}}}", r.x.raw, r.y.raw, r.z.raw); }

/// "about x, y and z" in degrees, as the scene file has it.
std::string remark(const Rotation& r) {
    return fmt::format("{}, {}, {} degrees about x, y, z; order {}", decimal(r.degrees[0]), decimal(r.degrees[1]),
                       decimal(r.degrees[2]), r.order);
}

std::string pose_text(const Pose& p, const Rotation& rotation) {
    constexpr int columns = nested_columns + field_columns;
    const Pose usual{};
    const std::string below = ",\n" + std::string(columns + sizeof(".rotation = {{") - 1, ' ');
    Fields to(columns);
    if (p.rotation != usual.rotation)
        to.add("rotation",
               "{{" + row_text(p.rotation.row[0]) + below + row_text(p.rotation.row[1]) + below +
                   row_text(p.rotation.row[2]) + "}}",
               remark(rotation));
    add(to, "scale", p.scale, usual.scale);
    add(to, "translation", p.translation, usual.translation);
    return to.braced();
}

}  // namespace

std::string camera_text(const Camera& c) {
    const Camera usual{};
    Fields to(nested_columns);
    add(to, "eye", c.eye, usual.eye);
    add(to, "target", c.target, usual.target);
    add(to, "up", c.up, usual.up);
    if (c.projection != usual.projection) to.add("projection", "shade16::Projection::orthographic");
    if (c.viewer != usual.viewer) to.add("viewer", "shade16::Viewer::local");
    if (c.fov_y != usual.fov_y)
        to.add("fov_y", fmt::format("{{{}u}}", c.fov_y.turns), decimal_degrees(c.fov_y) + " degrees");
    add(to, "view_height", c.view_height, usual.view_height);
    add(to, "near_distance", c.near_distance, usual.near_distance);
    add(to, "far_distance", c.far_distance, usual.far_distance);
    return to.braced();
}

std::string light_text(const Light& l) {
    const Light usual{};
    const char* const spaces[] = {"world", "view", "object"};
    Fields to(nested_columns);
    const char* const kinds[] = {"ambient", "directional", "point", "spot"};
    if (l.kind != usual.kind)
        to.add("kind", fmt::format("shade16::LightKind::{}", kinds[static_cast<std::size_t>(l.kind)]));
    add(to, "position", l.position, usual.position);
    add(to, "diffuse", l.diffuse, usual.diffuse);
    add(to, "specular", l.specular, usual.specular);
    if (l.intensity != usual.intensity)
        to.add("intensity", fmt::format("{{{}u, {}}}", l.intensity.mantissa, l.intensity.exponent),
               decimal(l.intensity));
    if (l.space != usual.space)
        to.add("space", fmt::format("shade16::Space::{}", spaces[static_cast<std::size_t>(l.space)]));
    if (l.attenuation != usual.attenuation)
        to.add("attenuation", attenuation_text(l.attenuation), remark(l.attenuation));
    add(to, "range", l.range, usual.range);
    if (l.spot != usual.spot) to.add("spot", spot_text(l.spot));
    return to.braced();
}

std::string spin_text(const Spin& s, const Rotation& rotation) {
    const Spin usual{};
    const char* const axes[] = {"x", "y", "z"};
    Fields to(nested_columns);
    if (s.start != usual.start) to.add("start", pose_text(s.start, rotation));
    add(to, "pivot", s.pivot, usual.pivot);
    add(to, "turns", s.turns, usual.turns);
    if (s.axis != usual.axis) to.add("axis", fmt::format("shade16::Axis::{}", axes[static_cast<std::size_t>(s.axis)]));
    return to.braced();
}

}  // namespace shade16::host
