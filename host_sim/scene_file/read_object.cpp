// Meshes and the objects that they are drawn as.
#include <algorithm>

#include "host_sim/scene_file/decimal.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range scales{0.0001, 16384}, degrees{-36'000, 36'000}, turns{-1000, 1000}, creases{0, 180};
constexpr Range tube_radii{.least = 0, .largest = 1, .without_least = true, .without_largest = true};
constexpr int most_rows = 2000;

const std::vector<std::string> shapes{"sphere", "torus", "cube", "quad"};

std::vector<std::string> keys_of(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::file:
            return {"file", "crease"};
        case ShapeKind::sphere:
            return {"shape", "slices", "stacks", "colors"};
        case ShapeKind::torus:
            return {"shape", "rings", "sides", "minor_radius", "colors"};
        default:
            return {"shape", "colors"};
    }
}

ShapeKind kind_of_mesh(const TableReader& any) {
    if (any.has("file") && any.has("shape")) throw any.wrong("file", "is beside 'shape'; expected one of the two");
    if (any.has("file")) return ShapeKind::file;
    const auto shape = any.word("shape", shapes);
    if (!shape) throw any.missing("file", R"(file = "model.obj", or shape = "sphere", "torus", "cube" or "quad")");
    return static_cast<ShapeKind>(*shape + 1);
}

void read_grid(const TableReader& table, MeshDescription& mesh) {
    const bool sphere = mesh.kind == ShapeKind::sphere;
    const char *const around_key = sphere ? "slices" : "rings", *const along_key = sphere ? "stacks" : "sides";
    int around = sphere ? 32 : 48, along = sphere ? 16 : 24;
    table.read(around_key, around, 3, most_rows);
    table.read(along_key, along, sphere ? 2 : 3, most_rows);
    if (around * along > static_cast<int>(max_mesh_vertices))
        throw table.wrong(around_key, fmt::format("times '{}' is {}; expected at most {} vertices", along_key,
                                                  around * along, max_mesh_vertices));
    mesh.around = static_cast<uint32_t>(around), mesh.along = static_cast<uint32_t>(along);
}

Rotation read_rotation(const TableReader& table) {
    Rotation rotation;
    table.read("rotation", rotation.degrees, degrees);
    const std::vector<std::string> orders{"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    if (const auto i = table.word("order", orders)) rotation.order = orders[*i];
    return rotation;
}

SpinDescription read_spin(const SceneTables& tables, const std::string& what, const TomlValue& value) {
    const TableReader table = tables.reader("the spin of " + what, value, {"turns", "axis"});
    SpinDescription spin{.turns = 1};
    table.read("turns", spin.turns, turns);
    if (const auto i = table.word("axis", {"x", "y", "z"})) spin.axis = static_cast<Axis>(*i);
    return spin;
}

}  // namespace

MeshDescription read_mesh(const SceneTables& tables, const TomlEntry& entry) {
    const std::string what = fmt::format("mesh '{}'", entry.key);
    const TableReader any = tables.reader(
        what, entry.value, {"file", "crease", "shape", "slices", "stacks", "rings", "sides", "minor_radius", "colors"});
    MeshDescription mesh{.name = entry.key, .line = entry.line, .kind = kind_of_mesh(any)};
    const TableReader table = tables.reader(what, entry.value, keys_of(mesh.kind));
    table.read("file", mesh.file);
    if (mesh.kind == ShapeKind::file && mesh.file.empty())
        throw table.wrong("file", "is empty; expected one such as \"model.obj\"");
    if (mesh.kind == ShapeKind::sphere || mesh.kind == ShapeKind::torus) read_grid(table, mesh);
    if (table.has("minor_radius")) {
        double radius = 0;
        table.read("minor_radius", radius, tube_radii);
        mesh.minor_radius = q30_of(radius);
    }
    table.read("colors", mesh.colors);
    if (table.has("crease")) {
        mesh.crease_degrees = 0;
        table.read("crease", *mesh.crease_degrees, creases);
    }
    return mesh;
}

ObjectDescription read_object(const SceneTables& tables, const TomlValue& value, std::size_t number) {
    const std::string what = fmt::format("object {}", number);
    const TableReader table = tables.reader(
        what, value, {"mesh", "material", "rotation", "order", "scale", "translation", "spin", "centred", "convex"});
    if (!table.has("mesh")) throw table.missing("mesh", "the name of a table under [meshes]");
    ObjectDescription object{.line = table.line()};
    table.read("mesh", object.mesh);
    table.read("material", object.material);
    object.rotation = read_rotation(table);
    table.read_scale("scale", object.scale, scales);
    table.read("translation", object.translation, coordinates);
    if (const TomlValue* const spin = table.find("spin")) object.spin = read_spin(tables, what, *spin);
    table.read("centred", object.centred);
    if (table.has("convex")) {
        object.convex = false;
        table.read("convex", *object.convex);
    }
    return object;
}

}  // namespace shade16::host
