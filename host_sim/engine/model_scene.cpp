#include "host_sim/engine/model_scene.hpp"

#include <algorithm>
#include <iterator>

#include "host_sim/engine/fit.hpp"
#include "host_sim/engine/unused_tables.hpp"

namespace shade16::host {

ModelScene::ModelScene(Model model, Viewport viewport, const Look& look) : model_(std::move(model)), baked_(quantize(model_)) {
    for (std::size_t i = 0; i < baked_.parts.size(); ++i) {
        objects_.push_back({mesh_of(baked_, i), baked_.parts[i].material, {}});
        look.apply_to(objects_.back().material);
    }
    scene_.objects = {objects_.data(), static_cast<uint32_t>(objects_.size())};
    scene_.background = rgb(0x101820);

    scale_ = fitting_scale(baked_);
    scene_.camera = fitting_camera(*this, viewport, figures_);
    lights_ = light_rig();
    scene_.lights = {lights_.data(), static_cast<uint32_t>(lights_.size())};
    lights_[key_light].intensity = fitting_key(*this, lights_[key_light], viewport, figures_);
    std::ranges::copy(warnings_of_unused_tables(scene_), std::back_inserter(baked_.warnings));
}

std::vector<Pose> ModelScene::poses(Angle turn) const {
    return std::vector<Pose>(objects_.size(), centred_pose(objects_.front().mesh, rotate_y(turn), scale_));
}

reference::Scene ModelScene::unquantized() const { return {scene_, original_meshes(model_, baked_)}; }

std::vector<reference::Mesh> original_meshes(const Model& model, const BakedModel& baked) {
    std::vector<reference::Mesh> result;
    const auto vectors = [](const std::vector<Double3>& from) {
        std::vector<glm::dvec3> to;
        for (const Double3& v : from) to.emplace_back(v[0], v[1], v[2]);
        return to;
    };
    for (const ModelPart& part : model.parts) {
        // A part that rounding left without triangles is no object.
        if (result.size() == baked.parts.size() || part.name != baked.parts[result.size()].name) continue;
        reference::Mesh mesh{vectors(model.positions), vectors(model.normals), vectors(model.colors), {}, {}};
        for (const auto& at : model.texcoords) mesh.texcoords.emplace_back(at[0], at[1]);
        for (const auto& t : part.triangles) mesh.triangles.push_back({t[0], t[1], t[2]});
        result.push_back(std::move(mesh));
    }
    return result;
}

}  // namespace shade16::host
