// VertexOrder: triangles ordered so that a small cache of lit vertices hits often, vertices ordered as they are met.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shade16/scene/mesh.hpp"

namespace shade16::host {

struct VertexOrder {
    std::vector<uint32_t> sources;      // the old number of each new vertex; vertices in no triangle are gone
    std::vector<Triangle> triangles{};  // new numbers; empty when there are more vertices than 16 bits can count
};

/// Deterministic.  Source: meshoptimizer's model of a FIFO cache, then its fetch order.
VertexOrder ordered_for_cache(const std::vector<std::array<uint32_t, 3>>& triangles, std::size_t vertex_count,
                              unsigned int cache_entries);

}  // namespace shade16::host
