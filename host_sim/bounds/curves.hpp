// What the charts of the report show.
#pragma once

#include <vector>

#include "host_sim/bounds/chart.hpp"
#include "host_sim/bounds/vertices.hpp"

namespace shade16::bounds {

/// The error of (N.H)^n against N.H, a chart a tier, a line an exponent.
std::vector<Chart> highlight_charts();

/// The error of unit vectors against the length of the vector that they are made of, octave by octave.
Chart normalize_chart();

/// The worst vertex of every tier and of a float pipeline, against the exponent, in levels.
Chart exponent_chart();

/// How often vertices take which share of their bound.
Chart share_chart(const std::vector<VertexResult>& vertices);

}  // namespace shade16::bounds
