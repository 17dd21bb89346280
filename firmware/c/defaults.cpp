// Things to begin with, as the C++ API has them.
#include "convert.hpp"

using namespace shade16;
using namespace shade16::c;

namespace {
constexpr shade16_light as_c(const Light& light) { return __builtin_bit_cast(shade16_light, light); }

shade16_light lamp(LightKind kind, shade16_vec3 position, shade16_color color, shade16_scaled intensity) {
    shade16_light light = as_c(Light{});
    light.kind = static_cast<uint8_t>(kind);
    light.position = position;
    light.diffuse = light.specular = color;
    light.intensity = intensity;
    return light;
}
}  // namespace

extern "C" {

shade16_camera shade16_default_camera() { return __builtin_bit_cast(shade16_camera, Camera{}); }
shade16_material shade16_default_material() { return as_c(Material{}); }
shade16_pose shade16_default_pose() { return __builtin_bit_cast(shade16_pose, Pose{}); }

shade16_light shade16_ambient_light(shade16_color color) { return as_c(ambient_light(as_rgb(color))); }
shade16_light shade16_directional_light(shade16_vec3 towards, shade16_color color, shade16_scaled intensity) {
    return lamp(LightKind::directional, towards, color, intensity);
}
shade16_light shade16_point_light(shade16_vec3 position, shade16_color color, shade16_scaled intensity) {
    return lamp(LightKind::point, position, color, intensity);
}
shade16_light shade16_spot_light(shade16_vec3 position, shade16_spot spot, shade16_color color, shade16_scaled intensity) {
    shade16_light light = lamp(LightKind::spot, position, color, intensity);
    light.spot = spot;
    return light;
}

shade16_color shade16_rgb(uint32_t hex) { return as_color(rgb(hex)); }
}
