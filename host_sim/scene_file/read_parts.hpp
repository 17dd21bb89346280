// The parts of a scene file, table by table. A key that is absent leaves the core's own default.
#pragma once

#include "host_sim/scene_file/description.hpp"
#include "host_sim/scene_file/table_reader.hpp"

namespace shade16::host {

/// A scene file's name, and its tables with what messages call them.
struct SceneTables {
    std::string file{};

    TableReader reader(std::string what, const TomlValue& table, std::vector<std::string> known) const {
        return {file, std::move(what), table, std::move(known)};
    }
};

OutputSettings read_output(const SceneTables& tables, const TomlValue& table);
Camera read_camera(const SceneTables& tables, const TomlValue& table);
Light read_light(const SceneTables& tables, const TomlValue& table, std::size_t number);
MeshDescription read_mesh(const SceneTables& tables, const TomlEntry& entry);
ObjectDescription read_object(const SceneTables& tables, const TomlValue& table, std::size_t number);

/// All materials at once, since they may be `like` each other. `warnings` are on their pictures.
std::vector<MaterialDescription> read_materials(const SceneTables& tables, const TomlTable& entries, std::vector<std::string>& warnings);

/// The names of the classic materials.
std::vector<std::string> classic_names();

/// "; did you mean 'x'?", or " 'a', 'b' or 'c'" after what was expected.
std::string suggestion(const std::string& typed, const std::vector<std::string>& known, const char* where);

}  // namespace shade16::host
