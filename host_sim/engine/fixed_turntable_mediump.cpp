#include "host_sim/engine/fixed_turntable.hpp"

namespace shade16::host {

template std::unique_ptr<Turntable> fixed_turntable_of<mediump>(const AnimatedScene&, Viewport, const TargetFormat&, int, Component);

}  // namespace shade16::host
