// A scene that moves, a model on a turntable or a scene file: frame after frame, whatever engine draws it.
#pragma once

#include <memory>
#include <string_view>

#include "host_sim/engine/animated_scene.hpp"
#include "host_sim/engine/formats.hpp"
#include "host_sim/io/image.hpp"

namespace shade16::host {

class Turntable {
public:
    Turntable() = default;
    Turntable(const Turntable&) = delete;
    Turntable& operator=(const Turntable&) = delete;
    virtual ~Turntable() = default;

    virtual Image draw(Angle turn) = 0;
};

/// The fixed-point engine: the very pixels of the target, in bands of so many rows (0: all at once).
std::unique_ptr<Turntable> fixed_turntable(const AnimatedScene& scene, Viewport viewport, std::string_view tier,
                                           const TargetFormat& target, int band_rows,
                                           Component component = Component::all);

/// Double precision on the file's own mesh, rounded once at the end: to 8 bits a channel, and to the format for raw.
std::unique_ptr<Turntable> reference_turntable(const AnimatedScene& scene, Viewport viewport, const TargetFormat& target,
                                               Component component = Component::all);

}  // namespace shade16::host
