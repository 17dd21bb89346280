// Lattice: where 16-bit positions can stand.
#pragma once

#include <vector>

#include "host_sim/model/double3.hpp"
#include "shade16/scene/mesh.hpp"

namespace shade16::host {

/// Points centre + k * 2^-fraction_bits, k of 16 bits.
struct Lattice {
    Vec3 centre{};
    int fraction_bits = 0;

    Double3 centre_value() const;
    Position16 nearest(const Double3& position) const;
    Double3 value(Position16 position) const;
};

/// The finest lattice that holds all positions: about the origin if that makes every one of them exact, else about the
/// middle of their box. The middle is itself rounded to the lattice, so that multiples of the step stay exact.
Lattice lattice_for(const std::vector<Double3>& positions);

}  // namespace shade16::host
