#include "host_sim/engine/unused_tables.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "shade16/shade16.hpp"

namespace shade16::host {

const char* obstacle_to_light_table(const Object& object, View<Light> lights, const Camera& camera) {
    if (!detail::is_phong(object.material)) return "its shading is not phong";
    if (!detail::may_use_light_table(object)) return "it has a texture, a relief or vertex colours";
    bool shines = false;
    for (const Light& light : lights) {
        if (light.intensity.is_zero() || light.kind == LightKind::ambient) continue;
        if (light.is_lamp()) return "a point or spot light shines";
        shines = shines || (object.material.specular != black && light.specular != black);
    }
    return shines && camera.sees_locally() ? "its highlights are seen by a local viewer" : nullptr;
}

std::vector<std::string> warnings_of_unused_tables(const Scene& scene) {
    std::map<std::string_view, std::vector<uint32_t>> objects;
    for (uint32_t i = 0; i < scene.objects.count; ++i) {
        if (scene.objects[i].material.light_table == LightTable::none) continue;
        if (const char* obstacle = obstacle_to_light_table(scene.objects[i], scene.lights, scene.camera)) objects[obstacle].push_back(i + 1);
    }
    std::vector<std::string> sentences;
    for (const auto& [obstacle, numbers] : objects)
        sentences.push_back(fmt::format("Object {}{} does not use its light table: {}.", numbers.front(),
                                        numbers.size() > 1 ? fmt::format(", like {} more,", numbers.size() - 1) : "", obstacle));
    return sentences;
}

}  // namespace shade16::host
