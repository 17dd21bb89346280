// SmoothNormals: for each distinct position the direction of the sum of its faces' unit normals.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "host_sim/model/polygon.hpp"

namespace shade16::host {

class SmoothNormals {
public:
    /// A face without area has no normal and adds none.
    void add_face(std::span<const Double3> corners) {
        const std::optional<Double3> normal = direction(area_vector(corners));
        if (!normal) return;
        for (const Double3& position : std::set<Double3>(corners.begin(), corners.end())) {
            Double3& sum = sums_[position];
            sum = sum + *normal;
        }
    }

    /// None where the faces' normals cancel out, as on a sheet with two sides.
    std::optional<Double3> at(const Double3& position) const {
        const auto entry = sums_.find(position);
        if (entry == sums_.end() || length(entry->second) < 1e-9) return std::nullopt;
        return direction(entry->second);
    }

private:
    std::map<Double3, Double3> sums_{};  // by value: this is the welding; -0 and 0 are one key
};

}  // namespace shade16::host
