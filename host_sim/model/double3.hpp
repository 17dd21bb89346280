// Double3: three doubles and the few operations that the importer needs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace shade16::host {

using Double3 = std::array<double, 3>;

inline Double3 operator+(const Double3& a, const Double3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Double3 operator-(const Double3& a, const Double3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Double3 operator*(const Double3& a, double k) { return {a[0] * k, a[1] * k, a[2] * k}; }

inline double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Double3& a) { return std::sqrt(dot(a, a)); }
inline Double3 cross(const Double3& a, const Double3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The direction of v; none for zero, infinite and NaN vectors. Scaled first, so that 1e-200 and 1e200 have one, too.
inline std::optional<Double3> direction(const Double3& v) {
    const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
    if (!(largest > 0) || !std::isfinite(dot(v, {1, 1, 1}))) return std::nullopt;
    const Double3 scaled{v[0] / largest, v[1] / largest, v[2] / largest};
    return scaled * (1 / length(scaled));
}

}  // namespace shade16::host
