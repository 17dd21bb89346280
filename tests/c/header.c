/* What a user of shade16.h may write in every language that it is for: its constants in initialisers of static things. */
#include "shade16.h"

static const shade16_material red = {SHADE16_RGB(0x200000), SHADE16_RGB(0xFF0000), SHADE16_RGB(0xFFFFFF), SHADE16_RGB(0), SHADE16_Q16(32),
                                     SHADE16_REFLECTION_BLINN_PHONG, SHADE16_SHADING_PHONG, SHADE16_NORMALS_LINEAR, 0};
static const shade16_scaled intensities[] = {SHADE16_INTENSITY(7, 10), SHADE16_INTENSITY(10000, 1)};
static const shade16_q16 numbers[] = {SHADE16_RATIO(1, 12), SHADE16_RATIO(-1, 12), SHADE16_Q16(-32768)};
static const shade16_angle angle = SHADE16_DEGREES(36);
static uint64_t memory[SHADE16_WORKSPACE_BYTES(1, 1, 24, 0) / 8 + 1];

/* What the constants are, held at compile time: an array can not have -1 elements. */
typedef char a_twelfth_is_rounded[SHADE16_RATIO(1, 12) == 5461 && SHADE16_RATIO(-1, 12) == -5461 && SHADE16_RATIO(1, 2) == 32768 ? 1 : -1];
typedef char a_degree_is_rounded[SHADE16_DEGREES(36) == 429496730u && SHADE16_DEGREES(180) == 2147483648u ? 1 : -1];
typedef char numbers_have_their_units[SHADE16_Q16(-1) == -65536 ? 1 : -1];

shade16_status shade16_header_test(const shade16_mesh *mesh) {
    shade16_scene scene;
    shade16_object object;
    shade16_renderer *renderer;
    object.mesh = mesh, object.material = red, object.pose = shade16_default_pose();
    scene.camera = shade16_default_camera();
    scene.camera.fov_y = angle, scene.camera.eye.z = numbers[0];
    scene.lights = 0, scene.light_count = 0;
    scene.objects = &object, scene.object_count = intensities[0].mantissa != 0;
    scene.background = shade16_rgb(0x101820);
    scene.width_px = scene.height_px = 64;
    return shade16_init(memory, sizeof memory, &scene, &renderer);
}
