// A model as a scene: fitted into the frame, lit, and turning.
#pragma once

#include <memory>
#include <vector>

#include "host_sim/engine/animated_scene.hpp"
#include "host_sim/engine/look.hpp"
#include "host_sim/model/quantize.hpp"

namespace shade16::host {

/// What the fit came to, over a whole turn.
struct FitFigures {
    double least_cover = 0, largest_cover = 0;  // the larger of the model's shares of the frame's width and height
    int brightest_code = 0;                     // of 255
    double saturated_share = 0;                 // of the covered pixels, in the worst frame
};

/// Owns a model's arrays and the scene that looks at them; it does not move, since the scene points into it.
class ModelScene final : public AnimatedScene {
public:
    /// `look` overrides what the materials say.
    ModelScene(Model model, Viewport viewport, const Look& look = {});

    const Scene& scene() const override { return scene_; }
    const BakedModel& baked() const { return baked_; }
    const FitFigures& figures() const { return figures_; }

    /// Every object's pose with the model turned about its vertical axis.
    std::vector<Pose> poses(Angle turn) const override;
    reference::Scene unquantized() const override;
    const std::string& source() const override { return baked_.source; }
    const std::vector<std::string>& warnings() const override { return baked_.warnings; }

private:
    Model model_;
    BakedModel baked_;
    std::vector<Light> lights_{};
    std::vector<Object> objects_{};
    Scene scene_{};
    Q16 scale_ = 1;
    FitFigures figures_{};
};

/// What the file says of each baked part, before quantisation.
std::vector<reference::Mesh> original_meshes(const Model& model, const BakedModel& baked);

/// The turn of one frame of a turntable.
constexpr Angle turn_of(int frame, int frames) {
    return {static_cast<uint32_t>((static_cast<uint64_t>(frame) << 32) / static_cast<uint64_t>(frames))};
}

}  // namespace shade16::host
