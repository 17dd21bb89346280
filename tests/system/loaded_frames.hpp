// What firmware/apps/scene.cpp must print for a scene file: the frames of the scene as it is loaded at run time.
#pragma once

#include <string>

#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"

namespace shade16::host {

/// FNV-1a over the bytes of the pixels, as firmware/runtime/hash_sink.hpp has it.
template <class Pixel>
uint32_t hash_of(const std::vector<Pixel>& pixels) {
    uint32_t hash = 2166136261u;
    const auto* const bytes = reinterpret_cast<const unsigned char*>(pixels.data());
    for (std::size_t i = 0; i < pixels.size() * sizeof(Pixel); ++i) hash = (hash ^ bytes[i]) * 16777619u;
    return hash;
}

/// A line "frame 0 0123abcd" a frame: four moments of the animation, or one where nothing turns.
inline std::string loaded_frames(const LoadedScene& scene) {
    const OutputSettings& output = scene.description().output;
    const auto turns = [](const Spin& spin) { return spin.turns != Q16{}; };
    const uint32_t moments = std::any_of(scene.spins().begin(), scene.spins().end(), turns) ? 4 : 1;
    std::string text;
    with_tier(output.tier, [&]<class Tier>(Tier) {
        RuntimeRenderer<Tier> renderer(scene.scene());
        for (uint32_t moment = 0; moment < moments; ++moment) {
            const std::vector<Pose> poses = scene.poses(elapsed(moment, moments));
            renderer.begin({.poses = poses.data()}, output.size);
            with_format(output.format, [&]<class Format>(Format) {
                text += fmt::format("frame {} {:08x}\n", moment, hash_of(renderer.template draw<Format>()));
            });
        }
    });
    return text;
}

}  // namespace shade16::host
