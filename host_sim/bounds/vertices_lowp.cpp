#include "host_sim/bounds/vertex_search.hpp"

namespace shade16::bounds {
template VertexFigures search<lowp>(const VertexDomain&);
}  // namespace shade16::bounds
