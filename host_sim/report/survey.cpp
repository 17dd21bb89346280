#include "host_sim/report/survey.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "host_sim/engine/formats.hpp"
#include "host_sim/reference/scene.hpp"
#include "host_sim/reference/transform.hpp"
#include "host_sim/report/memory.hpp"

namespace shade16::host {

namespace {

void add_objects(Survey& s, const Scene& scene, const std::vector<std::string>& names) {
    for (uint32_t i = 0; i < scene.objects.count; ++i) {
        const Mesh& mesh = scene.objects[i].mesh;
        const std::string name = i < names.size() && !names[i].empty() ? names[i] : fmt::format("object {}", i + 1);
        s.objects.push_back({name, mesh.positions.count, mesh.triangles.count, mesh.convex});
        s.vertices += mesh.positions.count;
        s.triangles += mesh.triangles.count;
        s.translucent_objects += scene.objects[i].material.alpha != 1_unorm;
    }
}

std::size_t distinct_materials(const Scene& scene) {
    std::vector<Material> seen;
    for (const Object& object : scene.objects)
        if (std::find(seen.begin(), seen.end(), object.material) == seen.end()) seen.push_back(object.material);
    return seen.size();
}

void measure_extents(Survey& s, const Scene& scene) {
    bool is_first = true;
    for (const Object& object : scene.objects)
        for (const glm::dvec3& p : reference::value(object.mesh).positions) {
            const glm::dvec3 world = reference::to_world(object.pose, p);
            s.low = is_first ? world : glm::min(s.low, world);
            s.high = is_first ? world : glm::max(s.high, world);
            is_first = false;
        }
}

template <PrecisionTier Tier, Channels Colors>
TierMemory tier_memory(const Scene& scene) {
    return {Tier::name, shininess_bytes<Tier>(scene), workspace_bytes<Tier, Colors>(scene, VertexStore::keep),
            workspace_bytes<Tier, Colors>(scene, VertexStore::replay)};
}

template <PixelFormat Format>
void add_memory(Survey& s, const Scene& scene) {
    constexpr Channels colors = channels_of_format<Format>;
    s.tiers = {tier_memory<lowp, colors>(scene), tier_memory<mediump, colors>(scene), tier_memory<highp, colors>(scene)};
    s.bits_a_pixel = bits_a_pixel<Format>();
    for (const int rows : {s.viewport.height, 40, 16, 8})
        if (rows < s.viewport.height || s.bands.empty())
            s.bands.push_back({rows, band_bytes<Format>(s.viewport.width, rows, s.needs.depth)});
}

}  // namespace

Survey survey(const Scene& scene, const std::string& source, const std::vector<std::string>& names, Viewport viewport,
              const std::string& format) {
    Survey s;
    s.source = source;
    add_objects(s, scene, names);
    s.materials = distinct_materials(scene);
    s.lights = scene.lights.count;
    measure_extents(s, scene);
    s.needs = needs_of(scene);
    s.picture_bytes = picture_bytes(scene);
    s.mesh_bytes = mesh_bytes(scene);
    s.viewport = viewport;
    s.format = format;
    with_format(format, [&]<class Format>(Format) { add_memory<Format>(s, scene); });
    return s;
}

}  // namespace shade16::host
