// Survey: what a scene is, which terms it needs and which it does not pay for, and what it takes in flash and RAM.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "shade16/shade16.hpp"

namespace shade16::host {

struct SurveyedObject {
    std::string name{};
    std::size_t vertices = 0, triangles = 0;
    bool convex = false;
};

struct TierMemory {
    std::string tier{};
    std::size_t shininess_bytes = 0, keep_bytes = 0, replay_bytes = 0;
};

struct BandMemory {
    int rows = 0;
    std::size_t bytes = 0;
};

struct Survey {
    std::string source{};
    std::vector<SurveyedObject> objects{};
    std::size_t vertices = 0, triangles = 0, materials = 0, lights = 0;
    glm::dvec3 low{}, high{};  // of all objects, as the scene's own poses place them
    std::size_t translucent_objects = 0;  // whose alpha is below 1: kept, and not drawn
    Needs needs{};
    std::size_t picture_bytes = 0;
    std::size_t mesh_bytes = 0;
    std::vector<TierMemory> tiers{};
    Viewport viewport{};
    std::string format{};
    int bits_a_pixel = 0;
    std::vector<BandMemory> bands{};  // the whole frame first
};

/// `names` has one for each object; a missing one becomes "object 3".
Survey survey(const Scene& scene, const std::string& source, const std::vector<std::string>& names, Viewport viewport,
              const std::string& format = Rgb565::name);

}  // namespace shade16::host
