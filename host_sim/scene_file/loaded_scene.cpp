#include "host_sim/scene_file/loaded_scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "host_sim/engine/unused_tables.hpp"
#include "host_sim/error.hpp"
#include "host_sim/scene_file/decimal.hpp"

namespace shade16::host {

namespace {

constexpr double farthest = 16384;  // the core's domain

Mat3 rotation_of(const Rotation& r) {
    Mat3 m;
    for (const char axis : r.order) {
        const auto i = static_cast<std::size_t>(axis - 'x');
        m = rotate(static_cast<Axis>(i), degrees_of(r.degrees[i])) * m;
    }
    return m;
}

Spin spin_of(const ObjectDescription& o, const Mesh& mesh) {
    const Pose start{rotation_of(o.rotation), o.scale, o.translation};
    return {start, o.centred ? mesh.centre : Vec3{}, o.spin.turns, o.spin.axis};
}

/// The distance of the farthest vertex from the point that the object turns about, scaled.
double reach(const BakedModel& model, const ObjectDescription& o) {
    const double step = std::ldexp(1.0, -model.fraction_bits);
    const Vec3 centre = o.centred ? Vec3{} : model.centre;
    double farthest_squared = 0;
    for (const BakedPart& part : model.parts)
        for (const Position16& p : part.positions) {
            const double x = (centre.x.raw / 65536.0 + p.x * step) * o.scale.x.raw / 65536.0;
            const double y = (centre.y.raw / 65536.0 + p.y * step) * o.scale.y.raw / 65536.0;
            const double z = (centre.z.raw / 65536.0 + p.z * step) * o.scale.z.raw / 65536.0;
            farthest_squared = std::max(farthest_squared, x * x + y * y + z * z);
        }
    return std::sqrt(farthest_squared);
}

}  // namespace

LoadedScene::LoadedScene(SceneDescription description, const Look& look) : description_(std::move(description)) {
    source_ = std::filesystem::path(description_.path).filename().string();
    warnings_ = description_.warnings;
    for (const MeshDescription& m : description_.meshes) {
        const bool is_textured = std::any_of(description_.objects.begin(), description_.objects.end(), [&](const ObjectDescription& o) {
            return o.mesh == m.name && (o.maps.texture || o.maps.bump);
        });
        meshes_.push_back(load_mesh(m, description_.path, is_textured));
        const std::vector<std::string>& more = meshes_.back().baked.warnings;
        warnings_.insert(warnings_.end(), more.begin(), more.end());
    }
    for (std::size_t i = 0; i < description_.objects.size(); ++i) add_object(i, look);
    const auto view = []<class T>(const std::vector<T>& v) {
        return View<T>(v.data(), static_cast<uint32_t>(v.size()));
    };
    scene_ = {description_.camera, view(description_.lights), view(objects_), description_.background};
    std::ranges::copy(warnings_of_unused_tables(scene_), std::back_inserter(warnings_));
}

void LoadedScene::add_object(std::size_t index, const Look& look) {
    const ObjectDescription& o = description_.objects[index];
    std::size_t m = 0;
    while (description_.meshes[m].name != o.mesh) ++m;
    refuse_what_reaches_too_far(o, index + 1, m);
    const BakedModel& baked = meshes_[m].baked;
    for (std::size_t part = 0; part < baked.parts.size(); ++part) {
        Object object{mesh_of(baked, part), o.value ? *o.value : baked.parts[part].material, {}};
        look.apply_to(object.material);
        if (o.convex == true && !object.mesh.convex && !hides_nothing_of_itself(object.mesh))
            throw wrong(o, index + 1,
                        fmt::format("says convex = true, but in the mesh '{}' one face can hide another; expected "
                                    "false, or no such key",
                                    o.mesh));
        object.mesh.convex = o.convex.value_or(object.mesh.convex);
        spins_.push_back(spin_of(o, object.mesh));
        object.pose = spins_.back().at({});
        objects_.push_back(object);
        origins_.push_back({index, m, part});
    }
}

void LoadedScene::refuse_what_reaches_too_far(const ObjectDescription& o, std::size_t number, std::size_t mesh) const {
    const double distance =
        reach(meshes_[mesh].baked, o) +
        std::hypot(o.translation.x.raw / 65536.0, o.translation.y.raw / 65536.0, o.translation.z.raw / 65536.0);
    if (distance > farthest)
        throw wrong(o, number,
                    fmt::format("reaches {:.0f} units from the origin; expected at most {:.0f}", distance, farthest));
}

Error LoadedScene::wrong(const ObjectDescription& o, std::size_t number, const std::string& complaint) const {
    return input_error("{}:{}: object {} {}.", description_.path, o.line, number, complaint);
}

std::vector<Pose> LoadedScene::poses(Angle elapsed) const {
    std::vector<Pose> all;
    for (const Spin& spin : spins_) all.push_back(spin.at(elapsed));
    return all;
}

reference::Scene LoadedScene::unquantized() const {
    reference::Scene result{scene_, {}};
    for (const Origin& origin : origins_) result.meshes.push_back(meshes_[origin.mesh].originals()[origin.part]);
    return result;
}

bool is_scene_file(const std::string& path) { return path.ends_with(".toml") || path.ends_with(".TOML"); }

}  // namespace shade16::host
