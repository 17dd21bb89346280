// A scene that is known only at run time, on the pipeline of all terms: the same frames as from the scene compiled in.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "shade16/shade16.hpp"

namespace shade16::host {

/// Owns the workspace and the shininess tables of one scene. The scene must outlive it and keep its arrays.
template <PrecisionTier Precision, Channels Colors = Channels::rgb, Needs N = all_needs>
class RuntimeRenderer {
public:
    using Tier = TierIn<Precision, Colors>;

    explicit RuntimeRenderer(const Scene& scene)
        : objects_(scene.objects.count), lights_(std::max<std::size_t>(scene.objects.count * scene.lights.count, 1)),
          shapes_(lights_.size()), vertices_(detail::vertex_count(scene)), faces_(detail::flat_face_count(scene)), split_(detail::split_light_count(scene)),
          light_tables_(detail::light_table_count(scene)), table_lights_(detail::table_light_count(scene)),
          pipeline_({scene, make_tables(scene)}, {objects_.data(), lights_.data(), vertices_.data(), faces_.data(), split_.data(), nullptr, 0,
                                                  light_tables_.data(), table_lights_.data(), shapes_.data()}) {}
    RuntimeRenderer(const RuntimeRenderer&) = delete;
    RuntimeRenderer& operator=(const RuntimeRenderer&) = delete;

    void use_shininess(const Shininess<Tier>* const* kernels) { pipeline_.use_shininess(kernels); }

    void begin(const Frame& frame, Viewport viewport) {
        viewport_ = viewport;
        pipeline_.begin(frame, viewport);
    }

    /// The whole frame's memory, drawn in bands of `band_rows` (0: all at once).
    template <PixelFormat Format>
    std::vector<typename Format::Pixel> draw(int band_rows = 0) {
        const auto width = static_cast<std::size_t>(viewport_.width), height = static_cast<std::size_t>(viewport_.height);
        const int rows = band_rows > 0 ? std::min(band_rows, viewport_.height) : viewport_.height;
        const auto stride = static_cast<std::size_t>(pixels_a_row<Format>(viewport_.width));
        std::vector<typename Format::Pixel> pixels(stride * height);
        std::vector<uint16_t> depth(width * static_cast<std::size_t>(rows));
        for (int y = 0; y < viewport_.height; y += rows) {
            const std::size_t first = static_cast<std::size_t>(y) * stride;
            draw(Band<Format>{pixels.data() + first, depth.data(), viewport_.width, y, std::min(rows, viewport_.height - y)});
        }
        return pixels;
    }
    template <PixelFormat Format>
    void draw(const Band<Format>& band) {
        pipeline_.draw(band);
    }

    ScreenVertex<Tier> lit_vertex(uint32_t object, uint32_t index) { return pipeline_.lit_vertex(object, index); }
    FaceColor<Tier> lit_face(uint32_t object, uint32_t face) { return pipeline_.lit_face(object, face); }

private:
    const Shininess<Tier>* const* make_tables(const Scene& scene) {
        for (const Object& object : scene.objects) {
            const bool shines = detail::has_specular(scene, object.material);
            tables_.push_back(shines ? std::make_unique<Shininess<Tier>>(shininess<Tier>(object.material.shininess)) : nullptr);
            table_of_object_.push_back(tables_.back().get());
        }
        return table_of_object_.data();
    }

    std::vector<std::unique_ptr<Shininess<Tier>>> tables_{};
    std::vector<const Shininess<Tier>*> table_of_object_{};
    std::vector<ObjectState<Tier>> objects_;
    std::vector<ObjectLight<Tier>> lights_;
    std::vector<LampShape> shapes_;
    std::vector<ScreenVertex<Tier>> vertices_;
    std::vector<FaceColor<Tier>> faces_;
    std::vector<SplitLightOf<Colors>> split_;
    std::vector<LightTableMemory<Tier>> light_tables_;
    std::vector<ObjectLight<Tier>> table_lights_;
    Viewport viewport_{};
    Pipeline<N, Precision, VertexStore::keep, Colors> pipeline_;
};

}  // namespace shade16::host
