// The same light in single precision, as a float engine computes it: what the fixed-point tiers are shown beside.
#pragma once

#include "host_sim/bounds/vertices.hpp"

namespace shade16::bounds {

/// The search of a domain, with a float pipeline in the engine's place. Its "bound" is highp's.
VertexFigures search_float32(const VertexDomain& domain);

}  // namespace shade16::bounds
