// Pipelines for some of all terms, chosen so that of any two terms one has both, one neither, and two have just one of them, as far
// as terms do not ask for each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shade16/scene/scene.hpp"
#include "shade16/scene/needs.hpp"
#include "shade16/pipeline/transform.hpp"

namespace shade16::pairwise {

/// What a term does not go without.
constexpr Needs closed(Needs n) {
    n.perspective |= !n.orthographic || n.local_viewer || n.perspective_texture;
    n.phong |= n.spherical || n.light_table || n.bump;
    n.gouraud |= n.unlit || (!n.flat && !n.phong);
    n.texture |= (n.bilinear && !n.bump && !n.light_table) || (n.perspective_texture && !n.bump);
    n.spot |= n.spot_exponent;
    n.point |= n.spot || n.range || n.falloff || n.attenuation;
    n.specular |= n.local_viewer || n.halfway || n.reflected;
    n.halfway |= n.specular && !n.reflected;
    n.directional |= n.light_table || ((n.diffuse || n.specular) && !n.point);
    n.diffuse |= (n.directional || n.point) && !n.specular;
    n.lit |= !n.unlit || n.diffuse || n.ambient || n.specular || n.directional || n.point || n.flat || n.phong;
    return n;
}

/// Found by find_rows.cpp.
inline constexpr Needs rows[] = {
    {.perspective = true, .lit = true, .flat = true, .gouraud = true, .phong = true, .texture = true,
     .bilinear = true, .ambient = true, .diffuse = true, .specular = true, .halfway = true, .directional = true,
     .point = true, .range = true, .stretch = true},
    {.perspective = true, .orthographic = true, .depth = true, .lit = true, .unlit = true, .gouraud = true,
     .phong = true, .spherical = true, .light_table = true, .vertex_colors = true, .perspective_texture = true,
     .bump = true, .ambient = true, .specular = true, .halfway = true, .reflected = true, .directional = true,
     .point = true, .attenuation = true, .falloff = true, .spot = true, .spot_exponent = true, .local_viewer = true},
    {.perspective = true, .depth = true, .lit = true, .gouraud = true, .vertex_colors = true},
    {.perspective = true, .orthographic = true, .lit = true, .gouraud = true, .texture = true, .bilinear = true,
     .perspective_texture = true, .diffuse = true, .specular = true, .reflected = true, .point = true,
     .attenuation = true, .falloff = true, .range = true, .spot = true, .spot_exponent = true, .local_viewer = true,
     .stretch = true},
    {.perspective = true, .orthographic = true, .lit = true, .unlit = true, .flat = true, .gouraud = true,
     .phong = true, .spherical = true, .light_table = true, .vertex_colors = true, .texture = true,
     .perspective_texture = true, .bump = true, .diffuse = true, .directional = true, .point = true,
     .attenuation = true, .stretch = true},
    {.perspective = true, .depth = true, .lit = true, .unlit = true, .flat = true, .gouraud = true, .phong = true,
     .spherical = true, .light_table = true, .bilinear = true, .bump = true, .diffuse = true, .specular = true,
     .halfway = true, .reflected = true, .directional = true, .point = true, .falloff = true, .range = true,
     .spot = true, .local_viewer = true},
    {.perspective = true, .lit = true, .flat = true, .phong = true, .spherical = true, .light_table = true,
     .vertex_colors = true, .bilinear = true, .perspective_texture = true, .bump = true, .ambient = true,
     .specular = true, .reflected = true, .directional = true, .local_viewer = true},
    {.orthographic = true, .depth = true, .lit = true, .unlit = true, .flat = true, .gouraud = true, .texture = true,
     .ambient = true, .specular = true, .halfway = true, .point = true, .falloff = true, .range = true, .spot = true,
     .spot_exponent = true, .stretch = true},
    {.perspective = true, .depth = true, .lit = true, .unlit = true, .flat = true, .gouraud = true, .phong = true,
     .texture = true, .bilinear = true, .perspective_texture = true, .bump = true, .ambient = true, .diffuse = true,
     .point = true, .attenuation = true, .range = true, .spot = true, .spot_exponent = true},
    {.perspective = true, .orthographic = true, .lit = true, .unlit = true, .gouraud = true, .phong = true,
     .spherical = true, .light_table = true, .texture = true, .bilinear = true, .diffuse = true, .specular = true,
     .halfway = true, .directional = true, .local_viewer = true, .stretch = true},
    {.perspective = true, .orthographic = true, .lit = true, .unlit = true, .gouraud = true, .phong = true,
     .spherical = true, .diffuse = true, .point = true, .attenuation = true, .falloff = true, .stretch = true},
    {.perspective = true, .orthographic = true, .depth = true, .lit = true, .gouraud = true, .vertex_colors = true,
     .texture = true, .perspective_texture = true, .diffuse = true, .specular = true, .halfway = true,
     .reflected = true, .directional = true, .point = true, .attenuation = true, .falloff = true, .range = true,
     .spot = true, .spot_exponent = true},
    {.perspective = true, .lit = true, .unlit = true, .gouraud = true, .phong = true, .light_table = true,
     .ambient = true, .specular = true, .halfway = true, .directional = true},
    {.perspective = true, .unlit = true, .gouraud = true},
};
inline constexpr std::size_t row_count = sizeof(rows) / sizeof(rows[0]);
static_assert(row_count + 2 <= 32, "compiled pipelines are dear: those of all terms, with and without depth, and at most 30 others");

/// A depth buffer is the one term that may change bits: where depth is too steep to be stepped, a triangle takes another path.
constexpr Needs all_terms(bool depth) {
    Needs all = all_needs;
    all.depth = depth;
    return all;
}

/// The pipelines by number: the rows, then all terms without depth, and with it.
constexpr Needs pipeline_needs(std::size_t i) { return i < row_count ? rows[i] : all_terms(i > row_count); }

/// A frame of a scene, in mediump and RGB565, drawn by the pipeline of a number.
template <std::size_t Number>
std::vector<uint16_t> draw(const Scene& scene, Viewport viewport);

}  // namespace shade16::pairwise
