#include "host_sim/cli/compare.hpp"

#include <algorithm>

#include "host_sim/cli/comparison_text.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/engine/formats.hpp"

namespace shade16::host {

namespace {

template <PrecisionTier Tier>
Comparison comparison(const AnimatedScene& scene, const CompareOptions& o) {
    const reference::Scene exact = reference::value(scene.scene()), original = scene.unquantized();
    Comparison result;
    Progress progress(fmt::format("comparing {}, frame", Tier::name), o.frames, o.quiet);
    for (int i = 0; i < o.frames; ++i) {
        progress.begin(i);
        const std::vector<Pose> poses = scene.poses(turn_of(i, o.frames));
        compare_frame<Tier>(result, exact, original, {.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = o.component},
                            o.size, o.target.format);
    }
    return result;
}

/// A frame that is black in both pictures compares nothing.
void refuse_what_is_not_there(Component component, const Needs& needs) {
    const bool is_there = component == Component::ambient    ? needs.ambient || needs.unlit
                          : component == Component::diffuse  ? needs.diffuse
                          : component == Component::specular ? needs.specular
                                                             : true;
    const char* const names[] = {"all", "ambient", "diffuse", "specular"};
    if (!is_there)
        throw input_error("--component {}: the scene has no such light; expected a component that it has.",
                          names[static_cast<std::size_t>(component)]);
}

}  // namespace

ExitCode compare(const CompareOptions& options) {
    CompareOptions o = options;
    const OpenScene open = open_scene(o);
    const AnimatedScene& scene = *open.scene;
    refuse_what_is_not_there(o.component, needs_of(scene.scene()));
    if (!o.quiet) print_warnings(scene.warnings());
    std::vector<Comparison> all;
    for (const char* tier : {lowp::name, mediump::name, highp::name})
        if (o.tier.empty() || o.tier == tier)
            all.push_back(with_tier(tier, [&]<class Tier>(Tier) { return comparison<Tier>(scene, o); }));
    print(o.json ? compare_json(o, all, scene) : comparison_text(all, scene, o, Ink(STDOUT_FILENO)));
    const bool holds = std::all_of(all.begin(), all.end(), [](const Comparison& c) { return c.holds(); });
    return holds ? ExitCode::ok : ExitCode::check;
}

}  // namespace shade16::host
