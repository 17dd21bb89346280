// AnimatedScene: a scene whose objects move, whether it was fitted to a model or written in a file.
#pragma once

#include <string>
#include <vector>

#include "host_sim/reference/scene.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

class AnimatedScene {
public:
    AnimatedScene() = default;
    AnimatedScene(const AnimatedScene&) = delete;
    AnimatedScene& operator=(const AnimatedScene&) = delete;
    virtual ~AnimatedScene() = default;

    /// It looks at arrays that the AnimatedScene owns.
    virtual const Scene& scene() const = 0;
    /// Every object's pose when so much of the animation is over.
    virtual std::vector<Pose> poses(Angle elapsed) const = 0;
    /// The same scene for the reference, with the files' own positions and normals, before quantisation.
    virtual reference::Scene unquantized() const = 0;
    /// The file's name, without its directory.
    virtual const std::string& source() const = 0;
    /// Sentences about what the files ask for and do not get.
    virtual const std::vector<std::string>& warnings() const = 0;
};

/// Of all objects.
inline std::size_t vertex_count(const Scene& scene) { return detail::vertex_count(scene); }
inline std::size_t triangle_count(const Scene& scene) {
    std::size_t sum = 0;
    for (const Object& object : scene.objects) sum += object.mesh.triangles.count;
    return sum;
}

}  // namespace shade16::host
