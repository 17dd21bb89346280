#include "host_sim/gallery/studio.hpp"

#include <filesystem>

#include "host_sim/engine/turntable.hpp"
#include "host_sim/io/magnify.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"
#include "host_sim/scene_file/read_scene.hpp"

namespace shade16::host {

namespace {

void vary(SceneDescription& scene, const Variation& v) {
    for (ObjectDescription& object : scene.objects) {
        if (!object.value) continue;
        if (v.shininess) object.value->shininess = Q16::from_raw(*v.shininess * 65536);
        if (v.matt) object.value->specular = black;
    }
}

}  // namespace

Panel Studio::panel(const std::string& name, const std::string& scene, const Variation& v) const {
    SceneDescription description = read_scene((std::filesystem::path(assets_) / scene).string());
    vary(description, v);
    const Viewport size = v.size.value_or(description.output.size);
    const std::string tier = mediump::name;  // whose promise is the heat maps' scale
    const LoadedScene loaded(std::move(description), v.look);
    Panel panel{name,
                magnified(fixed_turntable(loaded, size, tier, v.target, 0, v.component)->draw(v.elapsed), v.scale),
                {},
                {},
                v.scale};
    if (v.has_error)
        panel.error = difference_from_reference(loaded, v.elapsed, size, v.component, is_gray(v.target.format));
    return panel;
}

}  // namespace shade16::host
