// Statuses as sentences. A file of its own, so that a program that shows none has no byte of them.
#include "shade16.h"
#include "terms.hpp"

namespace {

struct Sentence {
    shade16_status status;
    const char* text;
};

#define SHADE16_C_SENTENCE(term, NAME) \
    {SHADE16_LACKS_##NAME, "The scene needs the term '" #term "', which this library was built without; expected '" #term "' among its TERMS."},

constexpr Sentence sentences[] = {
    {SHADE16_OK, "All is well."},
    {SHADE16_NULL_ARGUMENT, "A renderer, a scene, the memory or the pixels are NULL; expected the renderer that shade16_init gave, and memory of yours."},
    {SHADE16_NULL_ARRAY, "The lights, the objects, or a mesh's positions or triangles are NULL, and their count is not 0; expected an array."},
    {SHADE16_NULL_MESH, "An object's mesh is NULL; expected a mesh."},
    {SHADE16_MEMORY_MISALIGNED, "The memory for shade16_init does not begin at a multiple of 8; expected an array of uint64_t, or one aligned alike."},
    {SHADE16_MEMORY_TOO_SMALL, "The memory for shade16_init is too small for the scene; expected shade16_workspace_bytes of it."},
    {SHADE16_ARRAY_MISALIGNED, "Pixels, depth or an array of a mesh begin at an odd address; expected a multiple of 2."},
    {SHADE16_TOO_MANY_LIGHTS, "The scene has too many lights; expected at most 256."},
    {SHADE16_TOO_MANY_OBJECTS, "The scene has too many objects; expected at most 1024."},
    {SHADE16_TOO_MANY_VERTICES, "A mesh has too many vertices; expected at most 65535."},
    {SHADE16_TOO_MANY_TRIANGLES, "A mesh has too many triangles; expected at most 1048576."},
    {SHADE16_INDEX_OUT_OF_RANGE, "A corner of a triangle is no vertex of its mesh; expected indices below vertex_count."},
    {SHADE16_FRACTION_BITS_OUT_OF_RANGE, "A mesh's fraction_bits are out of range; expected 0 to 30."},
    {SHADE16_NO_NORMALS, "A mesh without normals has a material that is lit and not flat; expected normals, SHADE16_SHADING_FLAT or unlit."},
    {SHADE16_SCALE_NOT_POSITIVE, "A pose's scale is 0 or negative along an axis; expected more than 0."},
    {SHADE16_UNKNOWN_VALUE, "A field that takes one of a few values, such as a light's kind or a material's shading, holds another; expected a constant of shade16_scene.h."},
    {SHADE16_SCREEN_SIZE, "The scene's width_px or height_px are out of range; expected 1 to 2048."},
    {SHADE16_FIELD_OF_VIEW, "The camera's fov_y is 0 degrees, or 180 and more; expected an angle between."},
    {SHADE16_NEAR_AND_FAR, "The camera's near_distance is not above 0, or its far_distance not above that; expected 0 < near_distance < far_distance."},
    {SHADE16_VIEW_HEIGHT, "An orthographic camera's view_height is not above 0; expected what the frame's height shows."},
    {SHADE16_COUNT_DIFFERS, "An array of the frame has another count than the scene's; expected a light for each light, a pose and a material for each object."},
    {SHADE16_FLATNESS_CHANGED, "A material of the frame is flat where the scene's is not, or the other way round; expected the same, since memory depends on it."},
    {SHADE16_NOT_BEGUN, "There is no frame to draw a band of; expected a shade16_begin that answered SHADE16_OK."},
    {SHADE16_BAND_OUTSIDE, "The band has no rows, or some outside of the frame; expected 0 <= first_row and 1 <= rows <= height_px - first_row."},
    {SHADE16_NO_DEPTH, "The depth of a band is NULL, and this library has the term 'depth'; expected a uint16_t for each pixel of the band."},
    SHADE16_C_FOR_EACH_TERM(SHADE16_C_SENTENCE)};

}  // namespace

extern "C" const char* shade16_status_text(shade16_status status) {
    for (const Sentence& sentence : sentences)
        if (sentence.status == status) return sentence.text;
    return "This is no status of shade16; expected a constant of shade16_status.h.";
}
