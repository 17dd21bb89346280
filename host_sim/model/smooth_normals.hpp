// SmoothNormals: for each distinct position the direction of the sum of the unit normals of the faces that a face is smooth
// with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "host_sim/model/polygon.hpp"

namespace shade16::host {

/// A face as its neighbours see it. Smoothing group 0 is smooth with no other face.
struct FaceSide {
    Double3 normal{};
    unsigned group = 1;
};

class SmoothNormals {
public:
    /// Faces that meet at a greater angle keep their edge; a millionth of it is rounding.
    explicit SmoothNormals(double crease_degrees) : least_cosine_(std::cos(crease_degrees * std::numbers::pi / 180) - 1e-6) {}

    /// A face without area has no normal and adds none.
    void add_face(std::span<const Double3> corners, unsigned group) {
        const std::optional<Double3> normal = direction(area_vector(corners));
        if (!normal) return;
        for (const Double3& position : std::set<Double3>(corners.begin(), corners.end()))
            faces_[position].push_back({*normal, group});
    }

    /// The normal of one face at one of its corners; none where the normals cancel out, as on a sheet with two sides.
    std::optional<Double3> at(const Double3& position, const FaceSide& face) const {
        if (face.group == 0) return face.normal;
        const auto entry = faces_.find(position);
        if (entry == faces_.end()) return std::nullopt;
        Double3 sum{};
        for (const FaceSide& other : entry->second)
            if (other.group == face.group && dot(other.normal, face.normal) >= least_cosine_) sum = sum + other.normal;
        if (length(sum) < 1e-9) return std::nullopt;
        return direction(sum);
    }

private:
    std::map<Double3, std::vector<FaceSide>> faces_{};  // by value: this is the welding; -0 and 0 are one key
    double least_cosine_;
};

}  // namespace shade16::host
