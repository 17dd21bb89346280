// The terms by name: which status says that one is lacking.
#pragma once

#include "shade16/scene/needs.hpp"
#include "shade16_status.h"

/// use(term, NAME) for every term that a scene of C structs can ask for, in the order of their statuses.
#define SHADE16_C_FOR_EACH_TERM(use)                                                                                                \
    use(perspective, PERSPECTIVE) use(orthographic, ORTHOGRAPHIC) use(depth, DEPTH) use(lit, LIT) use(unlit, UNLIT) use(flat, FLAT)  \
    use(gouraud, GOURAUD) use(phong, PHONG) use(spherical, SPHERICAL) use(vertex_colors, VERTEX_COLORS) use(ambient, AMBIENT)        \
    use(diffuse, DIFFUSE) use(specular, SPECULAR) use(halfway, HALFWAY) use(reflected, REFLECTED) use(directional, DIRECTIONAL)      \
    use(point, POINT) use(attenuation, ATTENUATION) use(falloff, FALLOFF) use(range, RANGE) use(spot, SPOT)                          \
    use(spot_exponent, SPOT_EXPONENT) use(local_viewer, LOCAL_VIEWER) use(stretch, STRETCH)

namespace shade16::c {

#define SHADE16_C_ONE(term, NAME) +1
static_assert(sizeof(Needs) == 5 SHADE16_C_FOR_EACH_TERM(SHADE16_C_ONE), "a term of Needs has no status, besides five of maps and light tables");
#undef SHADE16_C_ONE

/// The status of the first term that is wanted and not there.
constexpr shade16_status first_lacking(const Needs& have, const Needs& want) {
#define SHADE16_C_TEST(term, NAME) \
    if (want.term && !have.term) return SHADE16_LACKS_##NAME;
    SHADE16_C_FOR_EACH_TERM(SHADE16_C_TEST)
#undef SHADE16_C_TEST
    return SHADE16_OK;
}

}  // namespace shade16::c
