#include "host_sim/cli/compare.hpp"

#include <algorithm>

#include "host_sim/cli/comparison_text.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/model_scene.hpp"
#include "host_sim/model/obj_import.hpp"

namespace shade16::host {

namespace {

template <PrecisionTier Tier>
Comparison comparison(const ModelScene& scene, const CompareOptions& o) {
    const reference::Scene exact = reference::value(scene.scene()), original = scene.unquantized();
    Comparison result;
    Progress progress(fmt::format("comparing {}, frame", Tier::name), o.frames, o.quiet);
    for (int i = 0; i < o.frames; ++i) {
        progress.begin(i);
        const std::vector<Pose> poses = scene.poses(turn_of(i, o.frames));
        compare_frame<Tier>(result, exact, original, {.camera = nullptr, .lights = nullptr, .poses = poses.data()},
                            o.size);
    }
    return result;
}

}  // namespace

ExitCode compare(const CompareOptions& o) {
    const ModelScene scene(import_obj(o.model), o.size, o.shading ? &*o.shading : nullptr);
    if (!o.quiet) print_warnings(scene.baked().warnings);
    std::vector<Comparison> all;
    for (const char* tier : {lowp::name, mediump::name, highp::name})
        if (o.tier.empty() || o.tier == tier)
            all.push_back(with_tier(tier, [&]<class Tier>(Tier) { return comparison<Tier>(scene, o); }));
    print(comparison_text(all, scene, o));
    const bool holds = std::all_of(all.begin(), all.end(), [](const Comparison& c) { return c.holds(); });
    return holds ? ExitCode::ok : ExitCode::check;
}

}  // namespace shade16::host
