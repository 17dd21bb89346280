#include "host_sim/model/polygon.hpp"

#include <numeric>
#include <optional>

namespace shade16::host {

namespace {

using Double2 = std::array<double, 2>;

/// Twice the signed area.
double turn(const Double2& a, const Double2& b, const Double2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The polygon seen along the axis where its shadow is largest, turning counter-clockwise.
std::vector<Double2> shadow(std::span<const Double3> corners) {
    const Double3 area = area_vector(corners);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::fabs(area[i]) > std::fabs(area[axis])) axis = i;
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (area[axis] < 0) std::swap(u, v);
    std::vector<Double2> flat;
    for (const Double3& corner : corners) flat.push_back({corner[u], corner[v]});
    return flat;
}

class EarClipper {
public:
    explicit EarClipper(std::span<const Double3> corners)
        : corners_(corners), flat_(shadow(corners)), rest_(corners.size()) {
        std::iota(rest_.begin(), rest_.end(), std::size_t{0});
    }

    std::vector<std::array<std::size_t, 3>> run() {
        while (rest_.size() > 3) {
            const std::optional<std::size_t> ear = best_ear();
            // Self-intersecting or without area: nothing is right, so cut anything and come to an end.
            const std::size_t cut = ear ? *ear : 1;
            triangles_.push_back(triangle(cut));
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(cut));
        }
        triangles_.push_back({rest_[0], rest_[1], rest_[2]});
        return std::move(triangles_);
    }

private:
    std::array<std::size_t, 3> triangle(std::size_t i) const {
        const std::size_t n = rest_.size();
        return {rest_[(i + n - 1) % n], rest_[i], rest_[(i + 1) % n]};
    }

    std::optional<std::size_t> best_ear() const {
        std::optional<std::size_t> best;
        double shortest = 0;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const auto [a, b, c] = triangle(i);
            const double diagonal = length(corners_[c] - corners_[a]);
            if ((best && diagonal >= shortest) || !is_ear(a, b, c)) continue;
            best = i;
            shortest = diagonal;
        }
        return best;
    }

    bool is_ear(std::size_t a, std::size_t b, std::size_t c) const {
        if (is_degenerate(corners_[a], corners_[b], corners_[c])) return false;
        if (turn(flat_[a], flat_[b], flat_[c]) <= 0) return false;
        for (const std::size_t other : rest_) {
            const Double2& p = flat_[other];
            if (p == flat_[a] || p == flat_[b] || p == flat_[c]) continue;
            const bool inside = turn(flat_[a], flat_[b], p) >= 0 && turn(flat_[b], flat_[c], p) >= 0 &&
                                turn(flat_[c], flat_[a], p) >= 0;
            if (inside) return false;
        }
        return true;
    }

    std::span<const Double3> corners_;
    std::vector<Double2> flat_;
    std::vector<std::size_t> rest_;
    std::vector<std::array<std::size_t, 3>> triangles_{};
};

}  // namespace

Double3 area_vector(std::span<const Double3> corners) {
    Double3 sum{};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Double3> corners) {
    if (corners.size() < 3) return {};
    return EarClipper(corners).run();
}

bool is_degenerate(const Double3& a, const Double3& b, const Double3& c) {
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    return length(cross(b - a, c - a)) <= 1e-10 * longest * longest;
}

}  // namespace shade16::host
