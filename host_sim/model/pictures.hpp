// Pictures: what one file's materials show, each picture read, warned of and kept once however many materials show it.
#pragma once

#include <map>
#include <tuple>

#include "host_sim/model/texture_file.hpp"

namespace shade16::host {

class Pictures {
public:
    /// `warnings` outlives it.
    explicit Pictures(std::vector<std::string>& warnings) : warnings_(warnings) {}

    std::shared_ptr<const TextureFile> texture(const std::string& path) {
        auto& file = textures_[path];
        if (!file) file = read_texture(path, warnings_);
        return file;
    }
    std::shared_ptr<const ReliefFile> relief(const std::string& path, double strength, ReliefKind kind) {
        auto& file = reliefs_[{path, strength, kind}];
        if (!file) file = read_relief(path, strength, kind, warnings_);
        return file;
    }

private:
    std::vector<std::string>& warnings_;
    std::map<std::string, std::shared_ptr<const TextureFile>> textures_{};
    std::map<std::tuple<std::string, double, ReliefKind>, std::shared_ptr<const ReliefFile>> reliefs_{};
};

}  // namespace shade16::host
