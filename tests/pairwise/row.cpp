// One pipeline: the build says which.
#include "tests/pairwise/rows.hpp"

#include "host_sim/engine/runtime_renderer.hpp"

namespace shade16::pairwise {

template <>
std::vector<uint16_t> draw<SHADE16_ROW>(const Scene& scene, Viewport viewport) {
    host::RuntimeRenderer<mediump, Channels::rgb, pipeline_needs(SHADE16_ROW)> renderer(scene);
    renderer.begin({}, viewport);
    return renderer.template draw<Rgb565>();
}

}  // namespace shade16::pairwise
