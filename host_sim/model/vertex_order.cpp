#include "host_sim/model/vertex_order.hpp"

#include <meshoptimizer.h>

namespace shade16::host {

VertexOrder ordered_for_cache(const std::vector<std::array<uint32_t, 3>>& triangles, std::size_t vertex_count,
                              unsigned int cache_entries) {
    std::vector<unsigned int> indices;
    for (const auto& triangle : triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
    std::vector<unsigned int> ordered(indices.size()), new_number(vertex_count);
    meshopt_optimizeVertexCacheFifo(ordered.data(), indices.data(), indices.size(), vertex_count, cache_entries);
    const std::size_t used =
        meshopt_optimizeVertexFetchRemap(new_number.data(), ordered.data(), ordered.size(), vertex_count);

    VertexOrder order{std::vector<uint32_t>(used)};
    for (uint32_t old = 0; old < vertex_count; ++old)
        if (new_number[old] < used) order.sources[new_number[old]] = old;
    if (used > max_mesh_vertices) return order;
    const auto index = [&](std::size_t i) { return static_cast<uint16_t>(new_number[ordered[i]]); };
    for (std::size_t i = 0; i < ordered.size(); i += 3)
        order.triangles.push_back({index(i), index(i + 1), index(i + 2)});
    return order;
}

}  // namespace shade16::host
