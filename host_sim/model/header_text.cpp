#include "host_sim/model/header_text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace shade16::host {

namespace {

/// Rows of as many elements as fit the line.
class Rows {
public:
    explicit Rows(std::string& out) : out_(out) {}
    void add(const std::string& element) {
        if (column_ == 0 || column_ + element.size() + 2 > header_columns) {
            out_ += column_ == 0 ? "    " : "\n    ";
            column_ = field_columns;
        } else {
            out_ += ' ';
            ++column_;
        }
        out_ += element + ',';
        column_ += element.size() + 1;
    }

private:
    std::string& out_;
    std::size_t column_ = 0;
};

std::string element(Position16 p) { return fmt::format("{{{}, {}, {}}}", p.x, p.y, p.z); }
std::string element(Normal14 n) { return fmt::format("{{{{{}}}, {{{}}}, {{{}}}}}", n.x.raw, n.y.raw, n.z.raw); }
std::string element(Rgb c) { return fmt::format("{{{{{}}}, {{{}}}, {{{}}}}}", c.r.raw, c.g.raw, c.b.raw); }
std::string element(TexCoord16 at) { return fmt::format("{{{}, {}}}", at.s, at.t); }
std::string element(Slope8 slope) { return fmt::format("{{{}, {}}}", slope.s, slope.t); }
std::string element(uint16_t texel) { return fmt::format("0x{:04X}", texel); }
std::string element(Triangle t) { return fmt::format("{{{}, {}, {}}}", t.a, t.b, t.c); }

template <class T>
std::string array(const char* type, const std::string& name, const std::vector<T>& values) {
    if (values.empty()) return {};
    std::string text = fmt::format("inline constexpr {} {}[] = {{\n", type, name);
    Rows rows(text);
    for (const T& value : values) rows.add(element(value));
    return text + "\n};\n";
}

/// A line that is too long goes on below its first element.
std::string wrapped(const std::string& line, const std::string& margin) {
    if (line.size() <= header_columns || line.find('\n') != std::string::npos) return line;
    const std::size_t end = line.rfind(", ", header_columns - 1);
    if (end == std::string::npos) return line;
    const std::string more = margin + std::string(field_columns, ' ');
    return line.substr(0, end + 1) + "\n" + wrapped(more + line.substr(end + 2), margin);
}

}  // namespace

std::string literal(Q16 x) {
    if (x.raw % 65536 == 0) return std::to_string(x.raw / 65536);
    return fmt::format("shade16::Q16::from_raw({})", x.raw);
}

std::string literal(Vec3 v) { return fmt::format("{{{}, {}, {}}}", literal(v.x), literal(v.y), literal(v.z)); }

std::string literal(Rgb c) {
    constexpr int a_code = 257;  // raw units of an 8-bit code
    if (c == black) return "shade16::black";
    if (c == white) return "shade16::white";
    if (c.r.raw % a_code == 0 && c.g.raw % a_code == 0 && c.b.raw % a_code == 0)
        return fmt::format("shade16::rgb(0x{:02X}{:02X}{:02X})", c.r.raw / a_code, c.g.raw / a_code, c.b.raw / a_code);
    return "shade16::Rgb" + element(c);
}

std::string arrays_text(const BakedPart& part, const std::string& stem) {
    return array("shade16::Position16", stem + "_positions", part.positions) +
           array("shade16::Normal14", stem + "_normals", part.normals) + array("shade16::Rgb", stem + "_colors", part.colors) +
           array("shade16::TexCoord16", stem + "_texcoords", part.texcoords) + array("shade16::Triangle", stem + "_triangles", part.triangles);
}

void Fields::add(const char* key, const std::string& value, const std::string& remark) {
    const std::string line = wrapped(fmt::format("{}.{} = {},", margin_, key, value), margin_);
    const std::string comment = remark.empty() ? "" : "// " + remark;
    const bool fits = line.find('\n') == std::string::npos && line.size() + 2 + comment.size() <= header_columns;
    if (comment.empty())
        text_ += line + "\n";
    else if (fits)
        text_ += line + "  " + comment + "\n";
    else
        text_ += margin_ + comment + "\n" + line + "\n";
}

std::string Fields::braced() const {
    if (text_.empty()) return "{}";
    return "{\n" + text_ + margin_.substr(std::min<std::size_t>(margin_.size(), field_columns)) + "}";
}

std::string mesh_text(const BakedModel& model, const BakedPart& part, const std::string& arrays, bool convex) {
    const Mesh plain{};
    Fields fields(field_columns);
    fields.add("positions", arrays + "_positions");
    fields.add("normals", arrays + "_normals");
    if (!part.colors.empty()) fields.add("colors", arrays + "_colors");
    if (!part.texcoords.empty()) fields.add("texcoords", arrays + "_texcoords");
    fields.add("triangles", arrays + "_triangles");
    if (model.centre != plain.centre) fields.add("centre", literal(model.centre));
    if (model.fraction_bits != plain.fraction_bits) fields.add("fraction_bits", std::to_string(model.fraction_bits));
    if (!part.texcoords.empty() && part.texcoord_bits != plain.texcoord_bits) fields.add("texcoord_bits", std::to_string(part.texcoord_bits));
    if (convex) fields.add("convex", "true");
    return fields.braced();
}

std::string texture_text(const TextureFile& file, const std::string& name) {
    const Texture& t = file.texture;
    return fmt::format("\n// {}: {}x{} texels, {} bytes of flash.\n", name, 1 << t.width_log2, 1 << t.height_log2, 2 * file.texels.size()) +
           array("uint16_t", name + "_texels", file.texels) +
           fmt::format("inline constexpr shade16::Texture {}{{{}_texels, {}, {}}};\n", name, name, t.width_log2, t.height_log2);
}

std::string relief_text(const ReliefFile& file, const std::string& name) {
    const SlopeMap& m = file.map;
    return fmt::format("\n// {}: {}x{} slopes, {} bytes of flash.\n", name, 1 << m.width_log2, 1 << m.height_log2, 2 * file.texels.size()) +
           array("shade16::Slope8", name + "_slopes", file.texels) +
           fmt::format("inline constexpr shade16::SlopeMap {}{{{}_slopes, {}, {}, {}}};\n", name, name, m.width_log2, m.height_log2, m.fraction_bits);
}

std::string material_text(const Material& m, const MapNames& maps) {
    const Material plain{};
    Fields fields(field_columns);
    if (m.ambient.given) fields.add("ambient", literal(m.ambient.color));
    if (m.diffuse != plain.diffuse) fields.add("diffuse", literal(m.diffuse));
    if (m.specular != plain.specular) fields.add("specular", literal(m.specular));
    if (m.emissive != plain.emissive) fields.add("emissive", literal(m.emissive));
    if (m.shininess != plain.shininess) fields.add("shininess", literal(m.shininess));
    if (m.reflection == Reflection::phong) fields.add("reflection", "shade16::Reflection::phong");
    if (m.shading == Shading::flat) fields.add("shading", "shade16::Shading::flat");
    if (m.shading == Shading::phong) fields.add("shading", "shade16::Shading::phong");
    if (m.normal_path == NormalPath::spherical) fields.add("normal_path", "shade16::NormalPath::spherical");
    if (m.light_table == LightTable::nearest) fields.add("light_table", "shade16::LightTable::nearest");
    if (m.light_table == LightTable::bilinear) fields.add("light_table", "shade16::LightTable::bilinear");
    if (m.texture != nullptr) fields.add("texture", "&" + maps.texture);
    if (m.bump != nullptr) fields.add("bump", "&" + maps.bump);
    if (m.filter == Filter::bilinear) fields.add("filter", "shade16::Filter::bilinear");
    if (m.mapping == Mapping::perspective) fields.add("mapping", "shade16::Mapping::perspective");
    if (m.alpha != plain.alpha) fields.add("alpha", fmt::format("{{{}}}", m.alpha.raw), "not drawn");
    if (m.unlit) fields.add("unlit", "true");
    return fields.braced();
}

std::string harmless(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\\' || static_cast<unsigned char>(c) < ' '; }, '_');
    return text;
}

}  // namespace shade16::host
