// What this build of the library contains, chosen by c_library.cmake: SHADE16_C_TERMS, SHADE16_C_TIER, SHADE16_C_CHANNELS.
#pragma once

#include "shade16/shade16.hpp"

#ifndef SHADE16_C_TIER
#define SHADE16_C_TIER mediump
#endif
#ifndef SHADE16_C_CHANNELS
#define SHADE16_C_CHANNELS rgb
#endif

namespace shade16::c {

namespace detail {
/// What a scene of C structs can ask for: everything but maps and light tables.
consteval Needs without_maps(Needs terms) {
    terms.light_table = terms.texture = terms.bilinear = terms.perspective_texture = terms.bump = false;
    return terms;
}

/// A term brings those that no scene has it without.
consteval Needs with_what_they_imply(Needs terms) {
    terms.spot |= terms.spot_exponent;
    terms.point |= terms.attenuation || terms.falloff || terms.range || terms.spot;
    terms.phong |= terms.spherical;
    terms.specular |= terms.halfway || terms.reflected || terms.local_viewer;
    terms.lit |= terms.ambient || terms.diffuse || terms.specular || terms.flat || terms.phong;
    return terms;
}

consteval Needs chosen_terms() {
#ifdef SHADE16_C_TERMS  // such as terms.perspective=terms.gouraud=true
    Needs terms;
    SHADE16_C_TERMS;
    return with_what_they_imply(without_maps(terms));
#else
    return without_maps(all_needs);
#endif
}
}  // namespace detail

inline constexpr Needs chosen_terms = detail::chosen_terms();
static_assert(chosen_terms.perspective || chosen_terms.orthographic, "a library draws in perspective, orthographically or both: name one in TERMS");
static_assert(chosen_terms.flat || chosen_terms.gouraud || chosen_terms.phong, "a library shades flat, gouraud or phong: name one in TERMS");

inline constexpr Channels channels = Channels::SHADE16_C_CHANNELS;
using Precision = SHADE16_C_TIER;
using Tier = TierIn<Precision, channels>;
using Kernel = Shininess<Precision>;
using LibraryPipeline = Pipeline<chosen_terms, Precision, VertexStore::keep, channels>;

}  // namespace shade16::c
