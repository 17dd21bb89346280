// What a scene takes in flash and in RAM, from the sizes of the core's own types.
#pragma once

#include <map>

#include "shade16/shade16.hpp"

namespace shade16::host {

/// The arrays of the scene's meshes; objects that share one pay for it once.
inline std::size_t mesh_bytes(const Scene& scene) {
    std::size_t sum = 0;
    for (uint32_t i = 0; i < scene.objects.count; ++i) {
        const Mesh& m = scene.objects[i].mesh;
        bool is_shared = false;
        for (uint32_t j = 0; j < i; ++j) is_shared |= scene.objects[j].mesh.positions.first == m.positions.first;
        if (is_shared) continue;
        sum += m.positions.count * sizeof(Position16) + m.normals.count * sizeof(Normal14) +
               m.colors.count * sizeof(Rgb) + m.texcoords.count * sizeof(TexCoord16) + m.triangles.count * sizeof(Triangle);
    }
    return sum;
}

/// The texels and slopes that the scene's materials look at, each once.
inline std::size_t picture_bytes(const Scene& scene) {
    std::map<const void*, std::size_t> pictures;
    const auto add = [&](const auto* map) {
        if (map != nullptr) pictures[map->texels.first] = map->texels.count * sizeof(*map->texels.first);
    };
    for (const Object& object : scene.objects) add(object.material.texture.at), add(object.material.bump.at);
    std::size_t sum = 0;
    for (const auto& [texels, bytes] : pictures) sum += bytes;
    return sum;
}

/// One table a distinct exponent, and what all exponents share.
template <PrecisionTier Tier>
std::size_t shininess_bytes(const Scene& scene) {
    std::size_t tables = 0;
    for (uint32_t i = 0; i < scene.objects.count; ++i)
        tables +=
            detail::has_specular(scene, scene.objects[i].material) && detail::first_with_same_shininess(scene, i) == i;
    const bool has_shared_tables = Arithmetic<Tier>::wide && tables > 0;
    return tables * sizeof(Shininess<Tier>) +
           (has_shared_tables ? sizeof(detail::log_table) + sizeof(detail::exp_table) : 0);
}

inline constexpr uint32_t usual_replay_slots = 64;

/// A Workspace of this scene, as this computer lays it out: pointers take 4 bytes an object more than on a 32-bit core.
template <PrecisionTier Precision, Channels Colors = Channels::rgb>
std::size_t workspace_bytes(const Scene& scene, VertexStore store, uint32_t slots = usual_replay_slots) {
    using detail::at_least_one;
    using Tier = TierIn<Precision, Colors>;
    const bool keeps = store == VertexStore::keep;
    const std::size_t vertices = keeps ? at_least_one(detail::vertex_count(scene)) : slots;
    const std::size_t faces = keeps ? at_least_one(detail::flat_face_count(scene)) : 1;
    return at_least_one(scene.objects.count) * sizeof(ObjectState<Tier>) +
           at_least_one(scene.objects.count * scene.lights.count) * sizeof(ObjectLight<Tier>) +
           vertices * sizeof(ScreenVertex<Tier>) + faces * sizeof(FaceColor<Tier>) +
           (keeps ? detail::split_light_count(scene) : 0) * sizeof(SplitLightOf<Colors>) +
           detail::light_table_count(scene) * sizeof(LightTableMemory<Tier>) + detail::table_light_count(scene) * sizeof(ObjectLight<Tier>) +
           (keeps ? 1 : slots) * sizeof(uint32_t) +
           (detail::shapes_lamps(needs_of(scene)) ? scene.objects.count * scene.lights.count * sizeof(LampShape) : 0);
}

/// One band, with depth where it is needed.
template <PixelFormat Format>
constexpr std::size_t band_bytes(int width, int rows, bool has_depth) {
    const std::size_t row = static_cast<std::size_t>(pixels_a_row<Format>(width)) * sizeof(typename Format::Pixel);
    return (row + (has_depth ? static_cast<std::size_t>(width) * sizeof(uint16_t) : 0)) * static_cast<std::size_t>(rows);
}

template <PixelFormat Format>
constexpr int bits_a_pixel() {
    if constexpr (GrayFormat<Format>) return Format::luma_bits;
    else return static_cast<int>(8 * sizeof(typename Format::Pixel));
}

}  // namespace shade16::host
