// Camera: where the picture is taken from.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/mat.hpp"
#include "shade16/num/normalize.hpp"

namespace shade16 {

enum class Projection : uint8_t { perspective, orthographic };

/// infinite: the viewer's direction is the camera's axis everywhere (OpenGL's default). local: it points at the eye.
/// An orthographic camera has its eye at infinity, so there both are the same.
enum class Viewer : uint8_t { infinite, local };

/// Right-handed, x right, y up, looking down -z.
struct Camera {
    Vec3 eye{0, 0, 3};
    Vec3 target{};
    Vec3 up{0, 1, 0};
    Projection projection = Projection::perspective;
    Viewer viewer = Viewer::infinite;
    Angle fov_y = 45_deg;       // perspective: the whole vertical angle, above 0 and below 180 degrees
    Q16 view_height = 2;        // orthographic: what the frame's height shows
    Q16 near_distance = 1;      // above 0; nearer geometry is clipped
    Q16 far_distance = 100;     // above near; farther geometry keeps the last depth value

    constexpr bool sees_locally() const { return viewer == Viewer::local && projection == Projection::perspective; }
};

namespace detail {
/// The direction of a vector of 64-bit components below 2^62; zero for a zero vector.
SHADE16_ONCE constexpr Normal30 unit_direction(int64_t x, int64_t y, int64_t z) {
    const int excess = max(0, 34 - leading_zeros(magnitude(x) | magnitude(y) | magnitude(z)));
    const auto shortened = [excess](int64_t c) { return static_cast<int32_t>(shift_right_round(c, excess)); };
    return normalize_finely({shortened(x), shortened(y), shortened(z)});
}
/// a x b of two unit vectors, normalised from the exact product: orthogonal to both however small it is; zero where they
/// are parallel.
SHADE16_ONCE constexpr Normal30 unit_cross(const Normal30& a, const Normal30& b) {
    const auto component = [](Q30 p, Q30 q, Q30 r, Q30 s) { return multiply(p.raw, q.raw) - multiply(r.raw, s.raw); };
    return unit_direction(component(a.y, b.z, a.z, b.y), component(a.z, b.x, a.x, b.z), component(a.x, b.y, a.y, b.x));
}
}  // namespace detail

/// The rotation from world to view: rows are right, up and back.
/// A target at the eye looks down -z; an `up` along the axis is replaced by the world axis least along it.
/// Error   rows are unit length and orthogonal within 5e-9.
constexpr Mat3 look_rotation(const Camera& camera) {
    const auto difference = [](Q16 a, Q16 b) { return int64_t{a.raw} - b.raw; };
    Normal30 back = detail::unit_direction(difference(camera.eye.x, camera.target.x), difference(camera.eye.y, camera.target.y),
                                           difference(camera.eye.z, camera.target.z));
    if (back == Normal30{}) back = {{}, {}, {Q30::one}};

    Normal30 right = detail::unit_cross(normalize(camera.up), back);
    if (right == Normal30{}) {
        const uint32_t x = magnitude(back.x.raw), y = magnitude(back.y.raw), z = magnitude(back.z.raw);
        const Normal30 least = x <= y && x <= z ? Normal30{{Q30::one}, {}, {}} : y <= z ? Normal30{{}, {Q30::one}, {}} : Normal30{{}, {}, {Q30::one}};
        right = detail::unit_cross(least, back);
    }
    return {{right, detail::unit_cross(back, right), back}};
}

}  // namespace shade16
