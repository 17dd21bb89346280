#include "host_sim/scene_file/describe_model.hpp"

#include <filesystem>

namespace shade16::host {

SceneDescription describe(const ModelScene& scene, const std::string& path) {
    const Scene& s = scene.scene();
    SceneDescription d;
    d.path = path;
    d.camera = s.camera;
    d.background = s.background;
    d.lights.assign(s.lights.begin(), s.lights.end());
    d.meshes.push_back({.name = "model", .file = std::filesystem::path(path).filename().string()});
    d.objects.push_back({.mesh = "model",
                         .material = own_material,
                         .scale = scene.poses({}).front().scale,
                         .spin = {.turns = 1, .axis = Axis::y},
                         .centred = true});
    return d;
}

}  // namespace shade16::host
