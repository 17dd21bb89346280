// The three errors, kept apart: (i) vertex colours on the same integers, against the tier's promise; (ii) pixels before
// rounding, the reference given the engine's own snapped vertices, against promise and stepping bound; (iii) the picture
// end to end against one drawn independently, reported and not promised.
#pragma once

#include <string>

#include "host_sim/reference/pipeline.hpp"
#include "shade16/target/pixel.hpp"
#include "shade16/pipeline/workspace.hpp"

namespace shade16::host {

/// Errors in levels against their bounds.
struct ErrorFigures {
    double largest = 0, sum = 0;
    double largest_of_bound = 0;  // the largest share of its bound that an error used up; above 1 is a broken promise
    std::size_t count = 0;

    void add(double error, double bound);
    double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
    bool holds() const { return largest_of_bound <= 1; }
};

struct Comparison {
    std::string tier{}, format{};
    double stepping_levels = 0;                       // of the widest codes
    double widest_code_levels = 0, narrowest_code_levels = 0;
    double promise_to_128 = 0, promise_to_1000 = 0;
    ErrorFigures vertices{}, pixels{};
    ErrorFigures tables{};           // pixels by a light table, against its own bound
    std::size_t beside_gate = 0;     // vertices where either side of the step at N.L = 0 was accepted
    std::size_t textured_pixels = 0;
    std::size_t other_texel = 0;     // textured pixels that show a neighbour of the exact texel
    std::size_t clipped_pixels = 0;  // of clipped triangles: not among `pixels`
    ErrorFigures picture{};          // bound 0: reported only
    std::size_t covered_by_one = 0, covered_by_both = 0;

    /// Whether the reference differs anywhere: one that never does is not compared with. Vertex colours alone may agree,
    /// where a scene is unlit and its colours are 0 and 1.
    bool differs() const { return vertices.largest > 0 || pixels.largest > 0; }
    bool holds() const { return vertices.holds() && pixels.holds() && tables.holds() && differs(); }
};

/// Adds one frame to a comparison. `exact` has the scene's own quantised meshes, `original` the file's. Of formats with
/// three channels RGB565 stands for all; a grey one is compared with the reference's luma. Nothing is dithered.
template <PrecisionTier Tier>
void compare_frame(Comparison& result, const reference::Scene& exact, const reference::Scene& original, const Frame& frame, Viewport viewport,
                   const std::string& format = Rgb565::name);

extern template void compare_frame<lowp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);
extern template void compare_frame<mediump>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);
extern template void compare_frame<highp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);

}  // namespace shade16::host
