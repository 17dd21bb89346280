#include "host_sim/scene_file/shape_text.hpp"

#include <fmt/format.h>

namespace shade16::host {

namespace {

// Clang 14 gives up on a constant expression after 2^20 steps: a torus of 64 x 32 still is within them, twice that is
// not.
constexpr uint32_t most_vertices = 2048;

}  // namespace

std::string shape_text(const MeshDescription& m, bool is_textured) {
    const char* const kind = is_textured ? "textured_" : "";
    if (!m.colors.empty() || m.around * m.along > most_vertices) return {};
    switch (m.kind) {
        case ShapeKind::cube:
            return fmt::format("shade16::{}cube.mesh()", kind);
        case ShapeKind::quad:
            return fmt::format("shade16::{}quad.mesh()", kind);
        case ShapeKind::sphere:
            return fmt::format("shade16::{}sphere<{}, {}>.mesh()", kind, m.around, m.along);
        case ShapeKind::torus:
            if (m.minor_radius.raw == torus_minor_radius)
                return fmt::format("shade16::{}torus<{}, {}>.mesh()", kind, m.around, m.along);
            return fmt::format("shade16::{}torus<{}, {}, {}>.mesh()", kind, m.around, m.along, m.minor_radius.raw);
        default:
            return {};
    }
}

}  // namespace shade16::host
