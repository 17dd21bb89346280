// Materials, and how one is `like` another.
#include <algorithm>
#include <filesystem>

#include "host_sim/model/pictures.hpp"
#include "host_sim/nearest_word.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range exponents{1, 1000};
constexpr std::size_t most_likes = 16;

class Materials {
public:
    Materials(const SceneTables& tables, const TomlTable& entries, Pictures& pictures)
        : tables_(tables), entries_(entries), pictures_(pictures) {}

    MaterialDescription read(const TomlEntry& entry, std::vector<std::string> likes = {}) const {
        const TableReader table =
            tables_.reader(fmt::format("material '{}'", entry.key), entry.value,
                           {"like", "ambient", "diffuse", "specular", "emissive", "shininess", "reflection", "shading", "normals",
                            "light_table", "texture", "bump", "bump_strength", "filter", "mapping", "alpha", "unlit"});
        if (entry.key == own_material)
            throw input_error("{}:{}: material '{}' is what a model's own materials are called; expected another name.",
                              tables_.file, entry.line, entry.key);
        likes.push_back(entry.key);
        MaterialDescription description = table.has("like") ? liked(table, likes) : MaterialDescription{};
        description.name = entry.key;
        Material& material = description.material;
        if (table.has("ambient")) {
            Rgb ambient{};
            table.read("ambient", ambient);
            material.ambient = ambient;
        }
        table.read("diffuse", material.diffuse);
        table.read("specular", material.specular);
        table.read("emissive", material.emissive);
        table.read("shininess", material.shininess, exponents);
        if (const auto i = table.word("reflection", {"blinn_phong", "phong"}))
            material.reflection = static_cast<Reflection>(*i);
        if (const auto i = table.word("shading", {"flat", "gouraud", "phong"}))
            material.shading = static_cast<Shading>(*i);
        if (const auto i = table.word("normals", {"linear", "spherical"}))
            material.normal_path = static_cast<NormalPath>(*i);
        if (const auto i = table.word("light_table", {"none", "nearest", "bilinear"}))
            material.light_table = static_cast<LightTable>(*i);
        read_maps(table, description);
        double alpha = material.alpha.raw / 65535.0;
        table.read("alpha", alpha, Range{0, 1});
        if (table.has("alpha")) material.alpha = Unorm16::from_raw(static_cast<uint32_t>(alpha * 65535 + 0.5));
        table.read("unlit", material.unlit);
        return description;
    }

private:
    template <class Read>
    auto read_picture(const TableReader& table, const char* key, Read read) const {
        std::string file;
        table.read(key, file);
        try {
            return read((std::filesystem::path(tables_.file).parent_path() / file).string());
        } catch (const Error& error) {
            throw Error(error.code, fmt::format("{}:{}: {}", tables_.file, table.line_of(key), error.what()));
        }
    }
    void read_maps(const TableReader& table, MaterialDescription& to) const {
        if (const auto i = table.word("filter", {"nearest", "bilinear"})) to.material.filter = static_cast<Filter>(*i);
        if (const auto i = table.word("mapping", {"affine", "perspective"})) to.material.mapping = static_cast<Mapping>(*i);
        if (table.has("texture")) {
            to.maps.texture = read_picture(table, "texture", [&](const std::string& path) { return pictures_.texture(path); });
            to.material.texture = &to.maps.texture->texture;
        }
        double strength = 1;
        table.read("bump_strength", strength, Range{-100, 100});
        if (table.has("bump")) {
            to.maps.bump = read_picture(table, "bump", [&](const std::string& path) { return pictures_.relief(path, strength, ReliefKind::automatic); });
            to.material.bump = &to.maps.bump->map;
        } else if (table.has("bump_strength")) {
            throw table.wrong("bump_strength", "stands without 'bump'; expected the name of a picture there");
        }
    }

    MaterialDescription liked(const TableReader& table, const std::vector<std::string>& likes) const {
        std::string name;
        table.read("like", name);
        const Material* const classic = find_material(name.c_str());
        if (name == likes.back() && classic != nullptr) return {name, *classic, {}};  // a variation under the same name
        if (std::find(likes.begin(), likes.end(), name) != likes.end())
            throw table.wrong(
                "like", fmt::format("goes round in a circle: {} is like {}", fmt::join(likes, " is like "), name));
        if (likes.size() == most_likes)
            throw table.wrong("like", fmt::format("is one of more than {} in a row; expected fewer", most_likes));
        for (const TomlEntry& entry : entries_)
            if (entry.key == name) return read(entry, likes);
        if (classic != nullptr) return {name, *classic, {}};
        std::vector<std::string> known = classic_names();
        for (const TomlEntry& entry : entries_) known.push_back(entry.key);
        throw table.wrong(
            "like", fmt::format("names no material: '{}'{}", name,
                                suggestion(name, known, "under [materials] or in the table of docs/scene-file.md")));
    }

    const SceneTables& tables_;
    const TomlTable& entries_;
    Pictures& pictures_;
};

}  // namespace

std::vector<MaterialDescription> read_materials(const SceneTables& tables, const TomlTable& entries, std::vector<std::string>& warnings) {
    Pictures pictures(warnings);
    const Materials materials(tables, entries, pictures);
    std::vector<MaterialDescription> all;
    for (const TomlEntry& entry : entries) all.push_back(materials.read(entry));
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
