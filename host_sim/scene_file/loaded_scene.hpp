// LoadedScene: a scene file with its meshes, ready to be drawn.
#pragma once

#include "host_sim/engine/animated_scene.hpp"
#include "host_sim/engine/look.hpp"
#include "host_sim/error.hpp"
#include "host_sim/scene_file/loaded_mesh.hpp"

namespace shade16::host {

/// Owns the meshes and the scene that looks at them.
class LoadedScene final : public AnimatedScene {
public:
    /// Reads the meshes. `look` overrides what the materials say. Throws input_error with the line.
    explicit LoadedScene(SceneDescription description, const Look& look = {});

    const Scene& scene() const override { return scene_; }
    std::vector<Pose> poses(Angle elapsed) const override;
    reference::Scene unquantized() const override;
    const std::string& source() const override { return source_; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

    const SceneDescription& description() const { return description_; }
    const std::vector<LoadedMesh>& meshes() const { return meshes_; }  // as many as the description has

    /// Where an object of the scene comes from: an object of the description, and a part of its mesh.
    struct Origin {
        std::size_t object = 0, mesh = 0, part = 0;
    };
    const std::vector<Origin>& origins() const { return origins_; }
    const std::vector<Spin>& spins() const { return spins_; }  // one an object of the scene

private:
    void add_object(std::size_t index, const Look& look);
    void refuse_what_reaches_too_far(const ObjectDescription& object, std::size_t number, std::size_t mesh) const;
    Error wrong(const ObjectDescription& object, std::size_t number, const std::string& complaint) const;

    SceneDescription description_;
    std::vector<LoadedMesh> meshes_{};
    std::vector<Object> objects_{};
    std::vector<Origin> origins_{};
    std::vector<Spin> spins_{};
    std::vector<std::string> warnings_{};
    std::string source_{};
    Scene scene_{};
};

/// Whether a path on the command line is a scene file's, by its ending.
bool is_scene_file(const std::string& path);

}  // namespace shade16::host
