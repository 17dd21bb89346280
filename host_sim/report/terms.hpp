// The terms of Needs by name, each with what it costs, for people and for JSON.
#pragma once

#include "shade16/scene/needs.hpp"

namespace shade16::host {

struct Term {
    const char* name;
    bool Needs::*is_needed;
    const char* cost;
};

inline constexpr Term terms[] = {
    {"perspective", &Needs::perspective, "a divide a vertex"},
    {"orthographic", &Needs::orthographic, "lengths that do not shrink with distance"},
    {"depth", &Needs::depth, "a depth buffer: several objects, or one that is not convex"},
    {"lit", &Needs::lit, "light on at least one object"},
    {"unlit", &Needs::unlit, "objects that show their own colour"},
    {"flat", &Needs::flat, "one colour a face"},
    {"gouraud", &Needs::gouraud, "colours interpolated along rows"},
    {"phong", &Needs::phong, "light a pixel, from interpolated normals"},
    {"spherical", &Needs::spherical, "a sine and a cosine for every 16 pixels of a row"},
    {"light_table", &Needs::light_table, "8 KB of RAM an object, and an entry looked up a pixel"},
    {"vertex_colors", &Needs::vertex_colors, "a factor a vertex"},
    {"texture", &Needs::texture, "a texel looked up a pixel"},
    {"bilinear", &Needs::bilinear, "four texels and nine products a pixel"},
    {"perspective_texture", &Needs::perspective_texture, "a reciprocal a pixel"},
    {"bump", &Needs::bump, "a slope looked up and a square root a pixel"},
    {"ambient", &Needs::ambient, "ambient or emissive light"},
    {"diffuse", &Needs::diffuse, "a dot product a vertex and light"},
    {"specular", &Needs::specular, "chords and shininess tables"},
    {"halfway", &Needs::halfway, "Blinn-Phong highlights: a half vector a vertex and light"},
    {"reflected", &Needs::reflected, "Phong highlights: a mirrored vector a vertex and light"},
    {"directional", &Needs::directional, "lights at infinity"},
    {"point", &Needs::point, "a square root a vertex and lamp"},
    {"attenuation", &Needs::attenuation, "a distance and a divide a vertex and lamp"},
    {"falloff", &Needs::falloff, "1/d^p: a logarithm a vertex and lamp"},
    {"range", &Needs::range, "lamps that end at a distance"},
    {"spot", &Needs::spot, "cones: a fine square root a vertex and spot"},
    {"spot_exponent", &Needs::spot_exponent, "a logarithm a vertex and spot"},
    {"local_viewer", &Needs::local_viewer, "a view vector and a square root a vertex"},
    {"stretch", &Needs::stretch, "a scale that differs by axis: normals are renormalised"},
};

/// A test holds this to be true, so that a new term is not forgotten here.
inline constexpr bool every_term_has_a_name = sizeof(terms) / sizeof(terms[0]) == sizeof(Needs);

}  // namespace shade16::host
