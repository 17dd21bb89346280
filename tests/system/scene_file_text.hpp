// Scene files for tests: from a few lines of text, from the project, and compared bit for bit.
#pragma once

#include "host_sim/scene_file/dump_scene.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"
#include "host_sim/scene_file/read_scene.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {

/// The least that a scene file must say; line 4 is the next one.
inline const std::string one_ball = "[meshes.ball]\nshape = \"sphere\"\n[[objects]]\nmesh = \"ball\"\n";

inline std::vector<std::string> scene_files() {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(source_directory() / "assets/scenes"))
        if (entry.path().extension() == ".toml") all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
}

template <class T>
bool same(View<T> a, View<T> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

inline bool same(const Mesh& a, const Mesh& b) {
    return same(a.positions, b.positions) && same(a.normals, b.normals) && same(a.colors, b.colors) &&
           same(a.triangles, b.triangles) && a.centre == b.centre && a.fraction_bits == b.fraction_bits &&
           a.convex == b.convex;
}

inline bool same(const Light& a, const Light& b) {
    return a.kind == b.kind && a.position == b.position && a.diffuse == b.diffuse && a.specular == b.specular &&
           a.intensity == b.intensity && a.space == b.space && a.attenuation == b.attenuation &&
           a.range == b.range && a.spot == b.spot;
}

inline bool same(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.projection == b.projection &&
           a.viewer == b.viewer && a.fov_y == b.fov_y && a.view_height == b.view_height &&
           a.near_distance == b.near_distance && a.far_distance == b.far_distance;
}

/// Pictures by their texels, since each scene reads its own.
inline bool same_pictures(const Material& a, const Material& b) {
    const auto same_map = [](const auto* x, const auto* y) {
        if (x == nullptr || y == nullptr) return x == y;
        return x->width_log2 == y->width_log2 && std::equal(x->texels.begin(), x->texels.end(), y->texels.begin(), y->texels.end());
    };
    return same_map(a.texture.at, b.texture.at) && same_map(a.bump.at, b.bump.at);
}
inline Material without_pictures(Material m) {
    m.texture = nullptr, m.bump = nullptr;
    return m;
}

inline void expect_same(const Scene& a, const Scene& b) {
    EXPECT_TRUE(same(a.camera, b.camera));
    EXPECT_EQ(a.background, b.background);
    ASSERT_EQ(a.lights.count, b.lights.count);
    for (uint32_t i = 0; i < a.lights.count; ++i) EXPECT_TRUE(same(a.lights[i], b.lights[i])) << "light " << i;
    ASSERT_EQ(a.objects.count, b.objects.count);
    for (uint32_t i = 0; i < a.objects.count; ++i) {
        EXPECT_TRUE(same(a.objects[i].mesh, b.objects[i].mesh)) << "object " << i;
        EXPECT_EQ(without_pictures(a.objects[i].material), without_pictures(b.objects[i].material)) << "object " << i;
        EXPECT_TRUE(same_pictures(a.objects[i].material, b.objects[i].material)) << "object " << i;
        EXPECT_EQ(a.objects[i].pose, b.objects[i].pose) << "object " << i;
    }
}

}  // namespace shade16::host
