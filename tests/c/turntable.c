/* firmware/apps/turntable.cpp in C99: the same frames. The build says which screen: SCREEN_WIDTH, SCREEN_HEIGHT, BAND_ROWS, PIXEL, DRAW
   (a function of shade16.h), BACKGROUND (0xRRGGBB), MODEL_SIZE (the teapot's units that become one), PIXELS_A_BYTE. */
#include "shade16.h"

#include "print.h"
#include "teapot.h"

#define LIGHTS 3
#define TEAPOT_VERTICES (sizeof(teapot_positions) / sizeof(teapot_positions[0]))
#define ROW_PIXELS ((SCREEN_WIDTH + PIXELS_A_BYTE - 1) / PIXELS_A_BYTE)

static uint64_t memory[(SHADE16_WORKSPACE_BYTES(1, LIGHTS, TEAPOT_VERTICES, 0) + 7) / 8];
static PIXEL pixels[ROW_PIXELS * BAND_ROWS];
static uint16_t depth[SCREEN_WIDTH * BAND_ROWS];

static int failed(shade16_status status) {
    if (status == SHADE16_OK) return 0;
    print_text(shade16_status_text(status));
    print_text("\n");
    return 1;
}

static uint32_t hash_of(uint32_t hash, const void *bytes, size_t count) {
    const unsigned char *byte = (const unsigned char *)bytes;
    size_t i;
    for (i = 0; i < count; ++i) hash = (hash ^ byte[i]) * 16777619u;
    return hash;
}

static void print_frame(uint32_t number, uint32_t hash) {
    static const char digits[] = "0123456789abcdef";
    char text[] = "frame 0 00000000\n";
    int i;
    text[6] = digits[number];
    for (i = 0; i < 8; ++i) text[8 + i] = digits[hash >> (28 - 4 * i) & 15];
    print_text(text);
}

static int draw_frame(shade16_renderer *renderer, uint32_t step) {
    const shade16_mat3 turn = shade16_multiply(shade16_rotate_y(SHADE16_DEGREES(45) * step), shade16_rotate_x(SHADE16_DEGREES(20)));
    const shade16_pose pose = shade16_centred_pose(teapot.centre, turn, 65536 / MODEL_SIZE);
    shade16_frame frame = {0};
    uint32_t hash = 2166136261u;
    int32_t y;
    frame.poses = &pose;
    frame.pose_count = 1;
    if (failed(shade16_begin(renderer, &frame))) return 1;
    for (y = 0; y < SCREEN_HEIGHT; y += BAND_ROWS) {
        const int32_t rows = SCREEN_HEIGHT - y < BAND_ROWS ? SCREEN_HEIGHT - y : BAND_ROWS;
        if (failed(DRAW(renderer, pixels, depth, y, rows))) return 1;
        hash = hash_of(hash, pixels, (size_t)rows * ROW_PIXELS * sizeof(PIXEL));
    }
    print_frame(step, hash);
    return 0;
}

int main(void) {
    static const shade16_vec3 sun = {SHADE16_Q16(-5), SHADE16_Q16(5), SHADE16_Q16(9)}, lamp = {SHADE16_Q16(4), SHADE16_Q16(1), SHADE16_Q16(3)};
    static const shade16_scaled bright = SHADE16_INTENSITY(7, 10), dim = SHADE16_INTENSITY(1, 4);
    shade16_light lights[LIGHTS];
    shade16_object object = {0};
    shade16_scene scene = {0};
    shade16_renderer *renderer;
    uint32_t step;

    lights[0] = shade16_ambient_light(shade16_rgb(0x484848));
    lights[1] = shade16_directional_light(sun, shade16_rgb(0xFFFFFF), bright);
    lights[2] = shade16_point_light(lamp, shade16_rgb(0x9FB8FF), dim);
    object.mesh = &teapot;
    object.material = *shade16_find_material("brass");
    object.pose = shade16_default_pose();
    scene.camera = shade16_default_camera();
    scene.camera.eye.y = SHADE16_Q16(2), scene.camera.eye.z = SHADE16_Q16(5);
    scene.camera.viewer = SHADE16_VIEWER_LOCAL;
    scene.camera.fov_y = SHADE16_DEGREES(36);
    scene.camera.near_distance = SHADE16_Q16(2), scene.camera.far_distance = SHADE16_Q16(9);
    scene.lights = lights, scene.light_count = LIGHTS;
    scene.objects = &object, scene.object_count = 1;
    scene.background = shade16_rgb(BACKGROUND);
    scene.width_px = SCREEN_WIDTH, scene.height_px = SCREEN_HEIGHT;

    if (failed(shade16_init(memory, sizeof(memory), &scene, &renderer))) return 1;
    for (step = 0; step < 8; ++step)
        if (draw_frame(renderer, step)) return 1;
    return 0;
}
