// The fit: a scale, a camera and a light rig for a model that comes without a scene.
#pragma once

#include "host_sim/engine/model_scene.hpp"

namespace shade16::host {

/// A power of two that brings the model's radius between 1 and 2, where Q16 positions have digits to spare.
Q16 fitting_scale(const BakedModel& model);

/// From a little above, at the distance where the model fills two thirds of the frame's width or height over its turn.
Camera fitting_camera(const ModelScene& scene, Viewport viewport, FitFigures& figures);

/// Ambient light, a key light whose intensity is fitted, and a cooler lamp from the other side.
std::vector<Light> light_rig();
inline constexpr std::size_t key_light = 1;

/// The strongest key light that leaves fewer than one in 125 of the model's pixels saturated. `key` is the rig's own,
/// and is tried at several strengths.
Scaled fitting_key(const ModelScene& scene, Light& key, Viewport viewport, FitFigures& figures);

}  // namespace shade16::host
