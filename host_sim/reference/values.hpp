// The core's integers as the doubles they stand for. The reference starts from the same integers as the engine.
#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include "shade16/num/channels.hpp"
#include "shade16/scene/scene.hpp"

namespace shade16::reference {

inline double value(Q16 q) { return std::ldexp(q.raw, -16); }
inline double value(Q30 q) { return std::ldexp(q.raw, -30); }
inline double value(Unorm16 u) { return u.raw / 65535.0; }
inline double value(Scaled s) { return std::ldexp(static_cast<double>(s.mantissa), s.exponent - 32); }
inline double radians(Angle a) { return std::ldexp(static_cast<double>(a.turns), -32) * 6.283185307179586476925; }

inline glm::dvec3 value(Vec3 v) { return {value(v.x), value(v.y), value(v.z)}; }
inline glm::dvec3 value(Rgb c) { return {value(c.r), value(c.g), value(c.b)}; }
/// The luma in all three channels. Source: ITU-R BT.601, with the engine's weights of 1/65536.
inline glm::dvec3 luma(const glm::dvec3& c) {
    return glm::dvec3((c.r * LumaWeights::red + c.g * LumaWeights::green + c.b * LumaWeights::blue) / 65536);
}
inline glm::dvec3 in_channels(const glm::dvec3& c, Channels channels) { return channels == Channels::luma ? luma(c) : c; }

inline glm::dvec3 value(Normal14 n) { return glm::dvec3(n.x.raw, n.y.raw, n.z.raw) / 16384.0; }

/// The rows of the core's matrix are the columns of GLM's transpose.
inline glm::dmat3 value(const Mat3& m) {
    const auto row = [](const Normal30& r) { return glm::dvec3(value(r.x), value(r.y), value(r.z)); };
    return glm::transpose(glm::dmat3(row(m.row[0]), row(m.row[1]), row(m.row[2])));
}

}  // namespace shade16::reference
