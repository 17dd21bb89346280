// All functions of which the engine promises something.
#pragma once

#include "host_sim/bounds/entry.hpp"

namespace shade16::bounds {

void add_bits(Entries& to);
void add_multiplies(Entries& to);
void add_numbers(Entries& to);
void add_colors(Entries& to);
void add_scaled(Entries& to);
void add_roots(Entries& to);
void add_reciprocals(Entries& to);
void add_vectors(Entries& to);
void add_unit_vectors(Entries& to);
void add_angles(Entries& to);
void add_matrices(Entries& to);
void add_blocks(Entries& to);
void add_powers(Entries& to);
void add_shininess(Entries& to);
void add_tables(Entries& to);
void add_light(Entries& to);
void add_glsl(Entries& to);

/// All of these.
Entries functions();

}  // namespace shade16::bounds
