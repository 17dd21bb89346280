// Rotations and poses.
#include "convert.hpp"

using namespace shade16;
using namespace shade16::c;

extern "C" {

shade16_mat3 shade16_rotate_x(shade16_angle angle) { return as_c(rotate_x({angle})); }
shade16_mat3 shade16_rotate_y(shade16_angle angle) { return as_c(rotate_y({angle})); }
shade16_mat3 shade16_rotate_z(shade16_angle angle) { return as_c(rotate_z({angle})); }
shade16_mat3 shade16_multiply(shade16_mat3 a, shade16_mat3 b) { return as_c(as_mat3(a) * as_mat3(b)); }

shade16_pose shade16_centred_pose(shade16_vec3 centre, shade16_mat3 rotation, shade16_q16 scale) {
    Mesh mesh;
    mesh.centre = __builtin_bit_cast(Vec3, centre);
    return __builtin_bit_cast(shade16_pose, centred_pose(mesh, as_mat3(rotation), Q16::from_raw(scale)));
}
}
