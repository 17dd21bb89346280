// Arcs of great circles: spherical interpolation of unit vectors.
#pragma once

#include "shade16/num/angle.hpp"
#include "shade16/num/normalize.hpp"
#include "shade16/num/reciprocal.hpp"

namespace shade16 {

inline constexpr Ulps arctangent_max_error = 2.5_ulps;  // of 2^-32 turn
// Of 2^-32 turn: the root's scaled_sqrt_max_error times sin cos / 2 pi, at most 19.3, the arctangent's 2.5, and five roundings.
inline constexpr Ulps arc_angle_max_error = 23_ulps;

/// The angle of a unit vector (x, y), y >= 0, from 0 to half a turn; 0 for (0, 0).
/// Range   x^2 + y^2 = 1 within 2^-27, what rounding leaves; a negative y counts as 0.
/// Error   arctangent_max_error.  Cost  a reciprocal, a sine and a cosine.
/// Source  Abramowitz and Stegun 4.4.47 (off 6e-4 rad), and one Newton step on sin(a - a0) = y cos a0 - x sin a0.
SHADE16_ONCE constexpr Angle arctangent(Q30 y, Q30 x) {
    const uint32_t up = magnitude(max(y.raw, int32_t{0})), along = magnitude(x.raw);
    const uint32_t large = max(up, along), small = min(up, along);
    if (large == 0) return {};
    const int shift = leading_zeros(large);
    const uint32_t r = mulhi(small << shift, reciprocal_of_normalized(large << shift));  // small / large as Q31
    const uint32_t rr = mulhi(r, r);                                                     // Q30
    constexpr uint32_t c1 = 0x288E9CFD, c3 = 0x0BC34B5A, c5 = 0x033B7428;               // 0.995354, 0.288679, 0.079331 over 2 pi, Q32
    const uint32_t octant = mulhi(r, c1 - 4 * mulhi(rr, c3 - 4 * mulhi(rr, c5))) * 2;   // turns
    constexpr uint32_t quarter = uint32_t{1} << 30;
    const uint32_t half = up > along ? quarter - octant : octant;
    const Angle rough{x.raw < 0 ? 2 * quarter - half : half};
    const SinCos at = sincos(rough);
    const int64_t sine_of_rest = (multiply(static_cast<int32_t>(up), at.cos.raw) - multiply(x.raw, at.sin.raw)) >> 30;
    const int64_t rest = multiply(saturate(sine_of_rest), int32_t{0x28BE60DC}) >> 30;  // over 2 pi
    const int64_t turns = static_cast<int64_t>(rough.turns) + rest;
    return {static_cast<uint32_t>(turns < 0 ? 0 : turns)};
}

inline constexpr Ulps arc_max_error = 32_ulps;  // of Q30, the whole vector: 3e-8; beyond a radian divided by sin(angle)

/// The shorter arc of a great circle between two unit vectors. Opposite ones choose no plane: the arc then leads over the
/// axis that is farthest from them, x before y before z. Equal ones, or a zero second one, make a point.
class Arc {
public:
    constexpr Arc() = default;
    constexpr Arc(const Normal30& a, const Normal30& b) : from_(a) {
        const int32_t cosine = as_q30(dot(a, b));
        const IVec3 rest = off(b, a);
        const IVec3 plane = off(normalize_finely(rest), a);  // twice, for what rounding left where there is hardly any
        // Of equal and of opposite vectors nothing remains, or what their lengths err by, which lies along a.
        const bool is_point = detail::magnitudes(plane) >> 27 == 0;
        if (!is_point) across_ = normalize_finely(plane);
        else if (cosine < 0) across_ = perpendicular(a);
        angle_ = is_point ? Angle{cosine < 0 ? uint32_t{1} << 31 : 0} : arctangent(length(rest), Q30{cosine});
    }
    /// Between the two.  Range  0 to half a turn.  Error  arc_angle_max_error.
    /// Cost    none: made with the arc.  Source  the arctangent of |b off a| and a.b.
    constexpr Angle angle() const { return angle_; }

    /// The unit vector at t, Q30 from 0 to 1: cos(t angle) a + sin(t angle) p, p being perpendicular to a in the arc's plane.
    /// Range   t from 0 to 1.  Error  arc_max_error.  Cost  sincos and six long multiplies.
    /// Source  an orthonormal pair in the arc's plane.
    /// Nothing is divided by sin(angle), and both ends of its range, 0 and half a turn, are as good as the middle.
    constexpr IVec3 at(int32_t t) const {
        const SinCos w = sincos({static_cast<uint32_t>(multiply(angle_.turns, static_cast<uint32_t>(t)) >> 30)});
        const auto component = [&](Q30 a, Q30 p) { return static_cast<int32_t>((multiply(a.raw, w.cos.raw) + multiply(p.raw, w.sin.raw)) >> 30); };
        return {component(from_.x, across_.x), component(from_.y, across_.y), component(from_.z, across_.z)};
    }

private:
    static constexpr int32_t as_q30(int64_t q60) { return saturate(shift_right_round(q60, 30)); }
    /// b less its part along a.
    static constexpr IVec3 off(const Normal30& b, const Normal30& a) {
        const int32_t along = as_q30(dot(a, b));
        const auto component = [along](Q30 p, Q30 q) { return saturate(p.raw - shift_right_round(multiply(q.raw, along), 30)); };
        return {component(b.x, a.x), component(b.y, a.y), component(b.z, a.z)};
    }
    static constexpr Q30 length(IVec3 v) {
        const uint64_t squared = static_cast<uint64_t>(multiply(v.x, v.x)) + static_cast<uint64_t>(multiply(v.y, v.y)) + static_cast<uint64_t>(multiply(v.z, v.z));
        return Q30::from_raw(static_cast<int64_t>(sqrt(Scaled::normalized(squared, -60)).to_fixed(30)));
    }
    /// From a towards the axis that it is farthest from.
    static constexpr Normal30 perpendicular(const Normal30& a) {
        const uint32_t x = magnitude(a.x.raw), y = magnitude(a.y.raw), z = magnitude(a.z.raw);
        Normal30 axis{};
        (x <= y && x <= z ? axis.x : y <= z ? axis.y : axis.z) = {Q30::one};
        return normalize_finely(off(axis, a));
    }

    Normal30 from_{}, across_{};
    Angle angle_{};
};

}  // namespace shade16
