// Studio: draws the gallery's panels of scene files, each with what varies from panel to panel.
#pragma once

#include <optional>
#include <string>

#include "host_sim/engine/look.hpp"
#include "host_sim/gallery/plate.hpp"
#include "host_sim/scene_file/description.hpp"

namespace shade16::host {

/// What a panel changes of the scene file that it draws.
struct Variation {
    Look look{};                          // of all materials
    std::optional<int> shininess{};       // of the scene file's own materials, as the next
    bool matt = false;  // no specular light
    Component component = Component::all;
    TargetFormat target{Rgb888::name, "none"};
    Angle elapsed{};                 // of the animation
    std::optional<Viewport> size{};  // the scene's own without it
    int scale = 1;                   // pixels are squares of so many
    bool has_error = true;           // with a heat map
};

class Studio {
public:
    /// `assets` is the project's directory of that name.
    explicit Studio(std::string assets) : assets_(std::move(assets)) {}

    /// One frame of `scene`, a path below `assets`.
    Panel panel(const std::string& name, const std::string& scene, const Variation& variation = {}) const;

private:
    std::string assets_;
};

}  // namespace shade16::host
