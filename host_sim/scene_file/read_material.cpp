// Materials, and how one is `like` another.
#include <algorithm>

#include "host_sim/nearest_word.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range exponents{1, 1000};

class Materials {
public:
    Materials(const SceneTables& tables, const TomlTable& entries) : tables_(tables), entries_(entries) {}

    Material read(const TomlEntry& entry, std::vector<std::string> likes = {}) const {
        const TableReader table =
            tables_.reader(fmt::format("material '{}'", entry.key), entry.value,
                           {"like", "ambient", "diffuse", "specular", "emissive", "shininess", "shading", "normals", "unlit"});
        if (entry.key == own_material)
            throw input_error("{}:{}: material '{}' is what a model's own materials are called; expected another name.",
                              tables_.file, entry.line, entry.key);
        likes.push_back(entry.key);
        Material material = table.has("like") ? liked(table, likes) : Material{};
        if (table.has("ambient")) {
            Rgb ambient{};
            table.read("ambient", ambient);
            material.ambient = ambient;
        }
        table.read("diffuse", material.diffuse);
        table.read("specular", material.specular);
        table.read("emissive", material.emissive);
        table.read("shininess", material.shininess, exponents);
        if (const auto i = table.word("shading", {"flat", "gouraud", "phong"}))
            material.shading = static_cast<Shading>(*i);
        if (const auto i = table.word("normals", {"linear", "spherical"}))
            material.normal_path = static_cast<NormalPath>(*i);
        table.read("unlit", material.unlit);
        return material;
    }

private:
    Material liked(const TableReader& table, const std::vector<std::string>& likes) const {
        std::string name;
        table.read("like", name);
        const Material* const classic = find_material(name.c_str());
        if (name == likes.back() && classic != nullptr) return *classic;  // a variation under the same name
        if (std::find(likes.begin(), likes.end(), name) != likes.end())
            throw table.wrong(
                "like", fmt::format("goes round in a circle: {} is like {}", fmt::join(likes, " is like "), name));
        for (const TomlEntry& entry : entries_)
            if (entry.key == name) return read(entry, likes);
        if (classic != nullptr) return *classic;
        std::vector<std::string> known = classic_names();
        for (const TomlEntry& entry : entries_) known.push_back(entry.key);
        throw table.wrong(
            "like", fmt::format("names no material: '{}'{}", name,
                                suggestion(name, known, "under [materials] or in the table of docs/scene-file.md")));
    }

    const SceneTables& tables_;
    const TomlTable& entries_;
};

}  // namespace

std::vector<MaterialDescription> read_materials(const SceneTables& tables, const TomlTable& entries) {
    std::vector<MaterialDescription> all;
    for (const TomlEntry& entry : entries) all.push_back({entry.key, Materials(tables, entries).read(entry)});
    return all;
}

std::vector<std::string> classic_names() {
    std::vector<std::string> names;
    for (const NamedMaterial& row : classic_materials) names.emplace_back(row.name);
    return names;
}

std::string suggestion(const std::string& typed, const std::vector<std::string>& known, const char* where) {
    const std::string near = nearest_word(typed, known);
    return near.empty() ? fmt::format("; expected one {}", where) : fmt::format("; the nearest one is '{}'", near);
}

}  // namespace shade16::host
