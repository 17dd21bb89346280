// What to draw, for shade16.h. Names, units and meanings are those of core/include/shade16/scene; docs/c.md has a table of units.
#ifndef SHADE16_SCENE_H
#define SHADE16_SCENE_H

#include <stdint.h>

// The engine reads a mesh's arrays where they lie, as its own types.
#ifdef __GNUC__
#define SHADE16_IN_PLACE __attribute__((__may_alias__))
#else
#define SHADE16_IN_PLACE
#endif

typedef int32_t shade16_q16;     // in units of 2^-16
typedef int32_t shade16_q30;     // in units of 2^-30
typedef uint32_t shade16_angle;  // in units of 2^-32 turn

// Constants for initialisers, made of whole numbers. SHADE16_RATIO(1, 12) is 1/12, rounded; SHADE16_DEGREES takes whole degrees.
#define SHADE16_Q16(whole) ((shade16_q16)((whole) * (int32_t)65536))
#define SHADE16_RATIO(n, d) ((shade16_q16)((n) < 0 ? -SHADE16_ROUNDED(-(n), d, 65536) : SHADE16_ROUNDED(n, d, 65536)))
#define SHADE16_DEGREES(whole) ((shade16_angle)(((((uint64_t)(whole)) << 32) + 180) / 360))
#define SHADE16_ROUNDED(n, d, unit) ((2 * (int64_t)(n) * (unit) + (d)) / (2 * (int64_t)(d)))
// An intensity of n / d, below 65536; SHADE16_INTENSITY(7, 10) is 0.7. Braces: for initialisers.
#define SHADE16_INTENSITY(n, d) { (uint32_t)SHADE16_ROUNDED(n, d, (n) / (d) < 256 ? 16777216 : 65536), (n) / (d) < 256 ? 8 : 16 }
// SHADE16_RGB(0xFF8855) is a colour, for initialisers; the function shade16_rgb is for all else.
#define SHADE16_RGB(hex) { (uint16_t)(((hex) >> 16 & 255) * 257), (uint16_t)(((hex) >> 8 & 255) * 257), (uint16_t)(((hex) & 255) * 257) }

typedef struct shade16_vec3 { shade16_q16 x, y, z; } shade16_vec3;
typedef struct shade16_mat3 { shade16_q30 row[3][3]; } shade16_mat3;
typedef struct SHADE16_IN_PLACE shade16_color { uint16_t r, g, b; } shade16_color;          // 65535 is 1.0
typedef struct shade16_scaled { uint32_t mantissa; int16_t exponent; } shade16_scaled;      // mantissa * 2^(exponent - 32)
typedef struct SHADE16_IN_PLACE shade16_position { int16_t x, y, z; } shade16_position;     // on the mesh's lattice
typedef struct SHADE16_IN_PLACE shade16_normal { int16_t x, y, z; } shade16_normal;         // 16384 is 1.0
typedef struct SHADE16_IN_PLACE shade16_triangle { uint16_t a, b, c; } shade16_triangle;    // counter-clockwise from outside

// A vertex stands at centre + position * 2^-fraction_bits. The arrays are read in place, as long as the renderer is used.
typedef struct shade16_mesh {
    const shade16_position *positions;   // vertex_count of each
    const shade16_normal *normals;       // NULL where nothing smooth is lit
    const shade16_color *colors;         // NULL, or a factor on ambient and diffuse light; of an unlit material the colour itself
    const shade16_triangle *triangles;
    uint32_t vertex_count;               // at most SHADE16_MAX_VERTICES
    uint32_t triangle_count;             // at most SHADE16_MAX_TRIANGLES
    shade16_vec3 centre;
    int8_t fraction_bits;                // 0 to 30
    uint8_t convex;                      // as `shade16 bake` says: drawn alone it needs no depth buffer
} shade16_mesh;

enum { SHADE16_SHADING_FLAT, SHADE16_SHADING_GOURAUD, SHADE16_SHADING_PHONG };
enum { SHADE16_NORMALS_LINEAR, SHADE16_NORMALS_SPHERICAL };
enum { SHADE16_REFLECTION_BLINN_PHONG, SHADE16_REFLECTION_PHONG };

typedef struct shade16_material {
    shade16_color ambient, diffuse, specular, emissive;
    shade16_q16 shininess;   // 1 to 1000; clamped outside
    uint8_t reflection;      // SHADE16_REFLECTION_...
    uint8_t shading;         // SHADE16_SHADING_...
    uint8_t normal_path;     // SHADE16_NORMALS_..., with SHADE16_SHADING_PHONG
    uint8_t unlit;           // not 0: shows its diffuse or vertex colours, whatever the light
} shade16_material;

enum { SHADE16_LIGHT_AMBIENT, SHADE16_LIGHT_DIRECTIONAL, SHADE16_LIGHT_POINT, SHADE16_LIGHT_SPOT };
enum { SHADE16_SPACE_WORLD, SHADE16_SPACE_VIEW, SHADE16_SPACE_OBJECT };

typedef struct shade16_attenuation { shade16_q16 constant, linear, quadratic, power; } shade16_attenuation;
typedef struct shade16_spot {
    shade16_vec3 direction;
    shade16_angle inner, outer;
    shade16_q16 exponent;
} shade16_spot;

typedef struct shade16_light {
    uint8_t kind;             // SHADE16_LIGHT_...
    shade16_vec3 position;    // of a lamp; of a directional light the direction towards it, of any length
    shade16_color diffuse;    // of an ambient light its colour
    shade16_color specular;
    shade16_scaled intensity;
    uint8_t space;            // SHADE16_SPACE_...: where position and direction are given
    shade16_attenuation attenuation;
    shade16_q16 range;        // 0: endless
    shade16_spot spot;
} shade16_light;

enum { SHADE16_PERSPECTIVE, SHADE16_ORTHOGRAPHIC };
enum { SHADE16_VIEWER_INFINITE, SHADE16_VIEWER_LOCAL };

typedef struct shade16_camera {
    shade16_vec3 eye, target, up;
    uint8_t projection;          // SHADE16_PERSPECTIVE or SHADE16_ORTHOGRAPHIC
    uint8_t viewer;              // SHADE16_VIEWER_...
    shade16_angle fov_y;         // perspective: above 0 and below half a turn
    shade16_q16 view_height;     // orthographic: above 0
    shade16_q16 near_distance;   // above 0
    shade16_q16 far_distance;    // above near_distance
} shade16_camera;

// v -> rotation * (scale * v) + translation
typedef struct shade16_pose {
    shade16_mat3 rotation;
    shade16_vec3 scale;          // above 0
    shade16_vec3 translation;
} shade16_pose;

typedef struct shade16_object {
    const shade16_mesh *mesh;
    shade16_material material;
    shade16_pose pose;
} shade16_object;

typedef struct shade16_scene {
    shade16_camera camera;
    const shade16_light *lights;
    const shade16_object *objects;
    uint32_t light_count;          // at most SHADE16_MAX_LIGHTS
    uint32_t object_count;         // at most SHADE16_MAX_OBJECTS
    shade16_color background;
    int32_t width_px, height_px;   // of the frame, 1 to 2048
} shade16_scene;

enum { SHADE16_COMPONENT_ALL, SHADE16_COMPONENT_AMBIENT, SHADE16_COMPONENT_DIFFUSE, SHADE16_COMPONENT_SPECULAR };

// What differs from the frame before. What is NULL stays as it was; an array has as many elements as the scene's.
typedef struct shade16_frame {
    const shade16_camera *camera;
    const shade16_light *lights;
    const shade16_pose *poses;
    const shade16_material *materials;   // may not become flat, nor cease to be
    uint32_t light_count, pose_count, material_count;
    uint8_t component;                   // SHADE16_COMPONENT_...: which part of the light shows
} shade16_frame;

#define SHADE16_MAX_LIGHTS 256u
#define SHADE16_MAX_OBJECTS 1024u
#define SHADE16_MAX_VERTICES 65535u
#define SHADE16_MAX_TRIANGLES 1048576u

#endif
