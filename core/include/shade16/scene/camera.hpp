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

/// The rotation from world to view: rows are right, up and back.
/// A target at the eye looks down -z; an `up` along the axis is replaced by the world axis least along it.
/// Error   each row is unit length within 2e-8 and the rows are orthogonal within 2e-8.
constexpr Mat3 look_rotation(const Camera& camera) {
    const auto difference = [](Q16 a, Q16 b) { return saturate((int64_t{a.raw} - b.raw) / 2); };
    const IVec3 axis{difference(camera.eye.x, camera.target.x), difference(camera.eye.y, camera.target.y),
                     difference(camera.eye.z, camera.target.z)};
    Normal30 back = normalize30(axis);
    if (back == Normal30{}) back = {{}, {}, {Q30::one}};

    const auto cross30 = [](const Normal30& a, const Normal30& b) {
        const auto component = [](Q30 p, Q30 q, Q30 r, Q30 s) {
            return saturate(shift_right_round((multiply(p.raw, q.raw) >> 1) - (multiply(r.raw, s.raw) >> 1), 29));
        };
        return IVec3{component(a.y, b.z, a.z, b.y), component(a.z, b.x, a.x, b.z), component(a.x, b.y, a.y, b.x)};
    };
    Normal30 right = normalize30(cross30(normalize(camera.up), back));
    if (right == Normal30{}) {
        const uint32_t x = magnitude(back.x.raw), y = magnitude(back.y.raw), z = magnitude(back.z.raw);
        const Normal30 least = x <= y && x <= z ? Normal30{{Q30::one}, {}, {}} : y <= z ? Normal30{{}, {Q30::one}, {}} : Normal30{{}, {}, {Q30::one}};
        right = normalize30(cross30(least, back));
    }
    return {{right, normalize30(cross30(back, right)), back}};
}

}  // namespace shade16
