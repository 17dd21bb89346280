// shade16 for C, for C++ before C++20, and for whatever calls C. C99 and C++98; docs/c.md has a whole program.
//
// No heap: all memory is the caller's. Nothing here crashes for values that are out of range: it says which, as a status.
// What a pointer points to must be there, and as long as its count says; indices and counts are checked against each other.
#ifndef SHADE16_H
#define SHADE16_H

#include <stddef.h>
#include <stdint.h>

#include "shade16_scene.h"
#include "shade16_status.h"

#ifdef __cplusplus
extern "C" {
#endif

// Lies at the beginning of the memory that shade16_init is given.
typedef struct shade16_renderer shade16_renderer;

#define SHADE16_ALIGNMENT 8  // of that memory: `static uint64_t memory[...]`

// What the memory takes, as a constant: never less than shade16_workspace_bytes. `vertices` are those of all objects, `flat_faces` the
// triangles of objects with SHADE16_SHADING_FLAT. What a vertex takes depends on the library's tier; its CMake target says so.
#define SHADE16_WORKSPACE_BYTES(objects, lights, vertices, flat_faces)                                                  \
    (SHADE16_RENDERER_BYTES + SHADE16_OBJECT_BYTES * (size_t)(objects) + SHADE16_LIGHT_BYTES * (size_t)(lights) +       \
     SHADE16_OBJECT_LIGHT_BYTES * (size_t)(objects) * (size_t)(lights) + SHADE16_VERTEX_BYTES * (size_t)(vertices) +    \
     SHADE16_FACE_BYTES * (size_t)(flat_faces))
#if UINTPTR_MAX > 0xFFFFFFFFu
#define SHADE16_RENDERER_BYTES 416
#define SHADE16_OBJECT_BYTES 592
#else
#define SHADE16_RENDERER_BYTES 320
#define SHADE16_OBJECT_BYTES 512
#endif
#define SHADE16_LIGHT_BYTES 88
#define SHADE16_OBJECT_LIGHT_BYTES 176
#ifndef SHADE16_VERTEX_BYTES
#define SHADE16_VERTEX_BYTES 14
#endif
#ifndef SHADE16_FACE_BYTES
#define SHADE16_FACE_BYTES 8
#endif

// The memory that a scene takes; 0 for a scene that shade16_init refuses.
size_t shade16_workspace_bytes(const shade16_scene *scene);

// Prepares a scene. It is copied, but for the meshes' arrays. *renderer is NULL where the status is not SHADE16_OK.
shade16_status shade16_init(void *memory, size_t bytes, const shade16_scene *scene, shade16_renderer **renderer);

// Begins a frame. NULL: as the one before, and the first one as the scene. After any other status than SHADE16_OK there is no frame to draw.
shade16_status shade16_begin(shade16_renderer *renderer, const shade16_frame *frame);

// Draws rows first_row to first_row + rows - 1 of the frame that was begun, background included, in any order. `pixels` has room for those
// rows, `depth` for a number a pixel of them; a library without the term `depth` takes NULL.
shade16_status shade16_draw_rgb565(shade16_renderer *renderer, uint16_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);
// The same with the bytes exchanged: the order in which SPI displays take them.
shade16_status shade16_draw_rgb565_swapped(shade16_renderer *renderer, uint16_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);

// Grey, in a library built with CHANNELS luma, which has these in place of the two above. Rows begin on a byte; of a byte's pixels the
// leftmost has the highest bits.
shade16_status shade16_draw_gray8(shade16_renderer *renderer, uint8_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);
shade16_status shade16_draw_gray4(shade16_renderer *renderer, uint8_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);
shade16_status shade16_draw_mono1(shade16_renderer *renderer, uint8_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);
// Dithered by a 4x4 Bayer matrix.
shade16_status shade16_draw_gray4_dithered(shade16_renderer *renderer, uint8_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);
shade16_status shade16_draw_mono1_dithered(shade16_renderer *renderer, uint8_t *pixels, uint16_t *depth, int32_t first_row, int32_t rows);

// A sentence: what was wrong and what was expected.
const char *shade16_status_text(shade16_status status);

// Things to begin with: what the C++ structs hold when nothing is said.
shade16_camera shade16_default_camera(void);
shade16_material shade16_default_material(void);
shade16_pose shade16_default_pose(void);
shade16_light shade16_ambient_light(shade16_color color);
shade16_light shade16_directional_light(shade16_vec3 towards, shade16_color color, shade16_scaled intensity);
shade16_light shade16_point_light(shade16_vec3 position, shade16_color color, shade16_scaled intensity);
shade16_light shade16_spot_light(shade16_vec3 position, shade16_spot spot, shade16_color color, shade16_scaled intensity);

// One of the 24 classic materials, as "brass"; NULL where there is none of that name. docs/gallery.md shows them.
const shade16_material *shade16_find_material(const char *name);

// 0xRRGGBB as a colour.
shade16_color shade16_rgb(uint32_t hex);

// Rotations about an axis, counter-clockwise when it points at you; and a * b: first b, then a.
shade16_mat3 shade16_rotate_x(shade16_angle angle);
shade16_mat3 shade16_rotate_y(shade16_angle angle);
shade16_mat3 shade16_rotate_z(shade16_angle angle);
shade16_mat3 shade16_multiply(shade16_mat3 a, shade16_mat3 b);
// Turns a mesh about its own centre and puts that at the origin.
shade16_pose shade16_centred_pose(shade16_vec3 centre, shade16_mat3 rotation, shade16_q16 scale);

#ifdef __cplusplus
}
#endif

#endif
