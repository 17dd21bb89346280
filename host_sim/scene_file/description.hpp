// SceneDescription: what a scene file says, every reference resolved and every default filled in, before meshes are
// read.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/engine/formats.hpp"
#include "host_sim/model/texture_file.hpp"

namespace shade16::host {

/// How the scene is drawn, unless the command line says otherwise. `frames` 0: as many as suit the kind of output.
struct OutputSettings {
    Viewport size{320, 240};
    TargetFormat target{};
    std::string tier = "mediump";
    int frames = 0, fps = 30;
    int band_rows = 0;  // 0: the whole frame at once
};

enum class ShapeKind { file, sphere, torus, cube, quad };

struct MeshDescription {
    std::string name{};
    int line = 0;
    ShapeKind kind = ShapeKind::file;
    std::string file{};                    // as the scene file has it
    std::optional<double> crease_degrees{};  // none: the file's own normals
    uint32_t around = 0, along = 0;        // slices and stacks, or rings and sides
    Q30 minor_radius{torus_minor_radius};  // of a torus, its ring's radius being 1
    std::vector<Rgb> colors{};             // a vertex each; empty: the model's own, if it has any
};

struct MaterialDescription {
    std::string name{};
    Material material{};
    MaterialMaps maps{};  // what its textures look at
};

/// `order` says which axis is turned about first, such as "xyz"; the axes are the world's.
struct Rotation {
    std::array<double, 3> degrees{};  // about x, y and z
    std::string order = "xyz";
};

/// So many turns about an axis of the world over the whole animation, after the rotation.
struct SpinDescription {
    Q16 turns = 0;
    Axis axis = Axis::y;
};

struct ObjectDescription {
    int line = 0;
    std::string mesh{}, material{};
    std::optional<Material> value{};  // of `material`; none: the model's own
    MaterialMaps maps{};              // of `value`
    Rotation rotation{};
    Vec3 scale{1, 1, 1}, translation{};
    SpinDescription spin{};
    bool centred = false;          // turns about the mesh's own centre, which is put at `translation`
    std::optional<bool> convex{};  // without it as the mesh is
};

struct SceneDescription {
    std::string path{};  // of the file; its meshes are beside it
    OutputSettings output{};
    Camera camera{};
    Rgb background = black;
    std::vector<Light> lights{};
    std::vector<MaterialDescription> materials{};
    std::vector<MeshDescription> meshes{};
    std::vector<ObjectDescription> objects{};
    std::vector<std::string> warnings{};  // sentences about pictures
};

/// The word that means a model's own material.
inline constexpr const char* own_material = "mtl";

}  // namespace shade16::host
