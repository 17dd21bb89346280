#include "host_sim/bounds/entries.hpp"

namespace shade16::bounds {

Entries functions() {
    Entries all;
    for (const auto add : {add_bits, add_multiplies, add_numbers, add_colors, add_scaled, add_roots, add_reciprocals,
                           add_vectors, add_unit_vectors, add_angles, add_matrices, add_blocks, add_powers,
                           add_shininess, add_tables, add_light, add_glsl})
        add(all);
    return all;
}

}  // namespace shade16::bounds
