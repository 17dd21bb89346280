// The values of a scene as C++ initialisers: raw integers, beside them in a comment what they mean, and nothing that is
// at its default.
#pragma once

#include <string>

#include "host_sim/model/header_text.hpp"
#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

std::string camera_text(const Camera& camera);
std::string light_text(const Light& light);

/// `rotation` is what the scene file says of the spin's start.
std::string spin_text(const Spin& spin, const Rotation& rotation);

}  // namespace shade16::host
