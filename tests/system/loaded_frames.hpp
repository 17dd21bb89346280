// What firmware/apps/scene.cpp must print for a scene file: the frames of the scene as it is loaded at run time.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "firmware/runtime/fnv1a.hpp"
#include "host_sim/engine/turntable.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"

namespace shade16::host {

/// Of a frame's bytes, as firmware/runtime/hash_sink.hpp has it.
inline uint32_t hash_of(const std::vector<uint8_t>& bytes) {
    Fnv1a hash;
    for (const uint8_t byte : bytes) hash.add(byte);
    return hash.value;
}

/// A line "frame 0 0123abcd" a frame: four moments of the animation, or one where nothing turns.
inline std::string loaded_frames(const LoadedScene& scene) {
    const OutputSettings& output = scene.description().output;
    const auto turns = [](const Spin& spin) { return spin.turns != Q16{}; };
    const uint32_t moments = std::any_of(scene.spins().begin(), scene.spins().end(), turns) ? 4 : 1;
    const auto turntable = fixed_turntable(scene, output.size, output.tier, output.target, output.band_rows);
    std::string text;
    for (uint32_t moment = 0; moment < moments; ++moment)
        text += fmt::format("frame {} {:08x}\n", moment, hash_of(turntable->draw(elapsed(moment, moments)).raw));
    return text;
}

}  // namespace shade16::host
