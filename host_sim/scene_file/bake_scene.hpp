// A loaded scene as C++ text: the very scene that the simulator draws, for a microcontroller's flash.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/scene_file/loaded_scene.hpp"

namespace shade16::host {

/// A header that includes <shade16/shade16.hpp> alone. In namespace `assets::NAME` it defines
///   `scene`      a shade16::Scene, and before it the meshes, materials, lights and objects that it consists of;
///   `spins`      one shade16::Spin an object: `spins[i].at(elapsed(k, frames))` is its pose in frame k;
///   `frames`     the length of the animation, 1 where nothing turns;
///   `viewport`, `Pixel` and `Tier`  how the scene file wants to be drawn.
/// A mesh that several objects share is written once; a built-in shape is left to the compiler where it can make it.
std::string bake_scene_header(const LoadedScene& scene, std::string_view name);

/// As many frames as the baked scene's `frames`.
int baked_frames(const LoadedScene& scene);

/// What the meshes that are drawn amount to, each counted once.
struct MeshFigures {
    std::size_t vertices = 0, triangles = 0, flash_bytes = 0;
};
MeshFigures mesh_figures(const LoadedScene& scene);

}  // namespace shade16::host
