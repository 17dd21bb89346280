/* What every program calls, and no more: what it links is what the library takes. */
#include "shade16.h"

#ifndef DRAW
#define DRAW shade16_draw_rgb565
#define PIXEL uint16_t
#endif

extern const shade16_scene *volatile the_scene;
const shade16_scene *volatile the_scene;
static uint64_t memory[1000];
static PIXEL pixels[320];
static uint16_t depth[320];

int main(void) {
    shade16_renderer *renderer;
    shade16_status status = shade16_init(memory, sizeof(memory), the_scene, &renderer);
    if (status == SHADE16_OK) status = shade16_begin(renderer, 0);
    if (status == SHADE16_OK) status = DRAW(renderer, pixels, depth, 0, 1);
    return (int)status;
}
