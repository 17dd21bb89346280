#include "host_sim/model/bake_header.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "host_sim/model/identifier.hpp"

namespace shade16::host {

namespace {

constexpr std::size_t line_columns = 120;

/// Rows of as many elements as fit the line.
class Rows {
public:
    explicit Rows(std::string& out) : out_(out) {}
    void add(const std::string& element) {
        if (column_ == 0 || column_ + element.size() + 2 > line_columns) {
            out_ += column_ == 0 ? "    " : "\n    ";
            column_ = 4;
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

std::string literal(Position16 p) { return fmt::format("{{{}, {}, {}}}", p.x, p.y, p.z); }
std::string literal(Normal14 n) { return fmt::format("{{{{{}}}, {{{}}}, {{{}}}}}", n.x.raw, n.y.raw, n.z.raw); }
std::string literal(Rgb c) { return fmt::format("{{{{{}}}, {{{}}}, {{{}}}}}", c.r.raw, c.g.raw, c.b.raw); }
std::string literal(Triangle t) { return fmt::format("{{{}, {}, {}}}", t.a, t.b, t.c); }
std::string literal(Q16 x) { return fmt::format("shade16::Q16::from_raw({})", x.raw); }

template <class T>
std::string array(const char* type, const std::string& name, const std::vector<T>& values) {
    if (values.empty()) return {};
    std::string text = fmt::format("inline constexpr shade16::{} {}[] = {{\n", type, name);
    Rows rows(text);
    for (const T& value : values) rows.add(literal(value));
    return text + "\n};\n";
}

std::string material(const Material& m, const std::string& name) {
    std::string text = fmt::format("inline constexpr shade16::Material {}{{\n", name);
    const auto field = [&](const char* key, const std::string& value) {
        text += fmt::format("    .{} = {},\n", key, value);
    };
    const auto color = [](Rgb c) { return "shade16::Rgb" + literal(c); };
    if (m.ambient.given) field("ambient", color(m.ambient.color));
    field("diffuse", color(m.diffuse));
    field("specular", color(m.specular));
    field("emissive", color(m.emissive));
    field("shininess", literal(m.shininess));
    if (m.shading == Shading::flat) field("shading", "shade16::Shading::flat");
    if (m.unlit) field("unlit", "true");
    return text + "};\n";
}

std::string mesh(const BakedModel& model, const BakedPart& part, const std::string& name) {
    std::string text = fmt::format(
        "inline constexpr shade16::Mesh {0}{{\n    .positions = {0}_positions,\n    .normals = {0}_normals,\n", name);
    if (!part.colors.empty()) text += fmt::format("    .colors = {}_colors,\n", name);
    text += fmt::format("    .triangles = {}_triangles,\n", name);
    text += fmt::format("    .centre = {{{},\n               {},\n               {}}},\n", literal(model.centre.x),
                        literal(model.centre.y), literal(model.centre.z));
    return text + fmt::format("    .fraction_bits = {},\n    .convex = {},\n}};\n", model.fraction_bits, part.convex);
}

std::string part_text(const BakedModel& model, const BakedPart& part, const std::string& name) {
    std::string text =
        fmt::format("\n// {}: {} vertices, {} triangles, {} bytes of flash{}.\n", name, part.positions.size(),
                    part.triangles.size(), part.flash_bytes(), part.convex ? ", convex" : "");
    text += array("Position16", name + "_positions", part.positions);
    text += array("Normal14", name + "_normals", part.normals);
    text += array("Rgb", name + "_colors", part.colors);
    text += array("Triangle", name + "_triangles", part.triangles);
    return text + mesh(model, part, name) + material(part.material, name + "_material");
}

/// A file's name inside a comment: nothing that could end or continue it.
std::string harmless(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\\' || static_cast<unsigned char>(c) < ' '; }, '_');
    return text;
}

std::string preamble(const BakedModel& model, const std::string& name) {
    return fmt::format(
        "// Made by: shade16 bake {} -o {}.hpp\n"
        "// {} vertices, {} triangles, {} bytes of flash. Positions are at most {:.3g} off, normals {:.3g} degrees.\n"
        "#pragma once\n\n#include <shade16/shade16.hpp>\n\nnamespace assets {{\n",
        harmless(model.source), name, model.vertex_count(), model.triangle_count(), model.flash_bytes(),
        model.max_position_error, model.max_normal_error_degrees);
}

}  // namespace

std::string bake_header(const BakedModel& model, std::string_view name) {
    static const std::array<std::string, 6> suffixes{"",        "_positions", "_normals",
                                                     "_colors", "_triangles", "_material"};
    const std::string stem = identifier(name);
    UniqueNames names;
    std::string text = preamble(model, stem);
    for (const BakedPart& part : model.parts) {
        const std::string wish = model.parts.size() == 1 ? stem : stem + "_" + identifier(part.name);
        text += part_text(model, part, names.claim(identifier(wish), suffixes));
    }
    return text + "\n}  // namespace assets\n";
}

}  // namespace shade16::host
