// A model as a scene: fitted into the frame, lit, and turning.
#pragma once

#include <memory>
#include <vector>

#include "host_sim/model/quantize.hpp"
#include "host_sim/reference/scene.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

/// What the fit came to, over a whole turn.
struct FitFigures {
    double least_cover = 0, largest_cover = 0;  // the larger of the model's shares of the frame's width and height
    int brightest_code = 0;                     // of 255
    double saturated_share = 0;                 // of the covered pixels, in the worst frame
};

/// Owns a model's arrays and the scene that looks at them; it does not move, since the scene points into it.
class ModelScene {
public:
    /// `shading` overrides the material's when it is given.
    ModelScene(Model model, Viewport viewport, const Shading* shading = nullptr);
    ModelScene(const ModelScene&) = delete;
    ModelScene& operator=(const ModelScene&) = delete;

    const Scene& scene() const { return scene_; }
    const BakedModel& baked() const { return baked_; }
    const FitFigures& figures() const { return figures_; }

    /// Every object's pose with the model turned about its vertical axis.
    std::vector<Pose> poses(Angle turn) const;
    /// The same scene for the reference, with the file's own positions and normals, before quantisation.
    reference::Scene unquantized() const;

private:
    Model model_;
    BakedModel baked_;
    std::vector<Light> lights_{};
    std::vector<Object> objects_{};
    Scene scene_{};
    Q16 scale_ = 1;
    FitFigures figures_{};
};

/// The turn of one frame of a turntable.
constexpr Angle turn_of(int frame, int frames) {
    return {static_cast<uint32_t>((static_cast<uint64_t>(frame) << 32) / static_cast<uint64_t>(frames))};
}

}  // namespace shade16::host
