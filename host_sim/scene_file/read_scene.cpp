#include "host_sim/scene_file/read_scene.hpp"

#include <algorithm>

#include "host_sim/model/text_lines.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

class SceneReader {
public:
    SceneReader(const TomlValue& root, const std::string& path)
        : tables_{path},
          root_(tables_.reader("the scene", root,
                               {"output", "camera", "background", "lights", "materials", "meshes", "objects"})) {}

    SceneDescription read() {
        scene_.path = tables_.file;
        if (const TomlValue* const output = root_.find("output")) scene_.output = read_output(tables_, *output);
        if (const TomlValue* const camera = root_.find("camera")) scene_.camera = read_camera(tables_, *camera);
        root_.read("background", scene_.background);
        for_each("lights",
                 [&](const TomlValue& v, std::size_t n) { scene_.lights.push_back(read_light(tables_, v, n)); });
        if (const TomlTable* const materials = table_of("materials"))
            scene_.materials = read_materials(tables_, *materials, scene_.warnings);
        if (const TomlTable* const meshes = table_of("meshes"))
            for (const TomlEntry& entry : *meshes) scene_.meshes.push_back(read_mesh(tables_, entry));
        for_each("objects", [&](const TomlValue& v, std::size_t n) { add_object(read_object(tables_, v, n), n); });
        if (scene_.objects.empty()) throw root_.missing("objects", "at least one [[objects]] with a mesh");
        return std::move(scene_);
    }

private:
    template <class Use>
    void for_each(const std::string& key, Use use) const {
        const TomlValue* const found = root_.find(key);
        if (found == nullptr) return;
        const auto* elements = std::get_if<TomlArray>(&found->value);
        if (elements == nullptr)
            throw root_.wrong(
                key, fmt::format("is {}; expected a list of tables, each below its own [[{}]]", kind_of(*found), key));
        for (std::size_t i = 0; i < elements->size(); ++i) use((*elements)[i], i + 1);
    }

    const TomlTable* table_of(const std::string& key) const {
        const TomlValue* const found = root_.find(key);
        if (found == nullptr) return nullptr;
        const auto* table = std::get_if<TomlTable>(&found->value);
        if (table == nullptr)
            throw root_.wrong(
                key, fmt::format("is {}; expected tables with names, such as [{}.wall]", kind_of(*found), key));
        return table;
    }

    void add_object(ObjectDescription object, std::size_t number) {
        const auto is_its_mesh = [&](const MeshDescription& mesh) { return mesh.name == object.mesh; };
        const auto mesh = std::find_if(scene_.meshes.begin(), scene_.meshes.end(), is_its_mesh);
        if (mesh == scene_.meshes.end()) {
            std::vector<std::string> known;
            for (const MeshDescription& m : scene_.meshes) known.push_back(m.name);
            throw absent(object, number, "mesh", object.mesh, suggestion(object.mesh, known, "under [meshes]"));
        }
        if (object.material.empty() && mesh->kind == ShapeKind::file) object.material = own_material;
        if (object.material == own_material && mesh->kind != ShapeKind::file)
            throw absent(object, number, "material", own_material,
                         "; a built-in shape has none of its own, so expected a name");
        if (object.material != own_material) {
            const MaterialDescription material = material_of(object, number);
            object.value = material.material, object.maps = material.maps;
        }
        scene_.objects.push_back(std::move(object));
    }

    MaterialDescription material_of(const ObjectDescription& object, std::size_t number) const {
        if (object.material.empty()) return {};
        std::vector<std::string> known = classic_names();
        for (const MaterialDescription& m : scene_.materials) {
            if (m.name == object.material) return m;
            known.push_back(m.name);
        }
        if (const Material* const classic = find_material(object.material.c_str())) return {object.material, *classic, {}};
        known.emplace_back(own_material);
        throw absent(object, number, "material", object.material,
                     suggestion(object.material, known, "under [materials] or in the table of docs/scene-file.md"));
    }

    Error absent(const ObjectDescription& object, std::size_t number, const char* kind, const std::string& name,
                 const std::string& hint) const {
        return input_error("{}:{}: object {} wants the {} '{}', which is not there{}.", tables_.file, object.line,
                           number, kind, name, hint);
    }

    SceneTables tables_;
    TableReader root_;
    SceneDescription scene_{};
};

}  // namespace

SceneDescription read_scene_text(std::string_view text, const std::string& path) {
    return SceneReader(parse_toml(text, path), path).read();
}

SceneDescription read_scene(const std::string& path) { return read_scene_text(read_text(path), path); }

}  // namespace shade16::host
