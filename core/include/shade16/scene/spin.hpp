// Spin: a pose that turns while a scene is shown.
#pragma once

#include "shade16/scene/scene.hpp"

namespace shade16 {

enum class Axis : uint8_t { x, y, z };

constexpr Mat3 rotate(Axis axis, Angle a) { return axis == Axis::x ? rotate_x(a) : axis == Axis::y ? rotate_y(a) : rotate_z(a); }

/// Turns about an axis of the world through the pivot, after the pose's own rotation.
struct Spin {
    Pose start{};         // its translation says where the pivot stands
    Vec3 pivot{};         // a point of the mesh, in the mesh's units
    Q16 turns = 0;        // over the whole animation; negative: clockwise
    Axis axis = Axis::y;

    /// The pose when so much of the animation is over.
    constexpr Pose at(Angle elapsed) const {
        const int64_t angle = shift_right_round(int64_t{turns.raw} * elapsed.turns, 16);
        const Mat3 rotation = rotate(axis, {static_cast<uint32_t>(angle)}) * start.rotation;
        const Vec3 arm{pivot.x * start.scale.x, pivot.y * start.scale.y, pivot.z * start.scale.z};
        return {rotation, start.scale, start.translation - rotation * arm};
    }
};

/// How much of an animation is over at the start of frame `frame` of `frames`.
constexpr Angle elapsed(uint32_t frame, uint32_t frames) {
    return {static_cast<uint32_t>((uint64_t{frame} << 32) / frames)};
}

}  // namespace shade16
