// How far a picture is from another: of two that are shown, and of the engine's colours from double precision.
#pragma once

#include <vector>

#include "host_sim/engine/animated_scene.hpp"
#include "host_sim/io/image.hpp"

namespace shade16::host {

/// Of two pictures of one size, by pixel; a level is 1/255, and of three channels the worst one counts.
struct PictureDifference {
    double share = 0;  // of all pixels, that differ
    int largest_levels = 0;
    double mean_levels = 0;  // of those that differ
};
PictureDifference difference(const Image& a, const Image& b);

/// The colours of mediump before the display rounds them, against the independent double-precision picture of the
/// file's own mesh: shading, stepping, snapping of vertices and quantisation of the mesh together.
struct ReferenceDifference {
    int width = 0, height = 0;
    std::vector<double> levels{};                // by pixel; 0 where either did not draw
    std::vector<bool> covered_by_one{};          // by pixel
    double largest_levels = 0, mean_levels = 0;  // of the pixels that both drew
    std::size_t covered_by_both = 0, covered_by_one_alone = 0;

    std::size_t beyond(double limit_levels) const;
    void add(const ReferenceDifference& another);  // to the figures alone
};

/// `is_gray`: of the luma that grey targets have.
ReferenceDifference difference_from_reference(const AnimatedScene& scene, Angle elapsed, Viewport viewport,
                                              Component component, bool is_gray);

}  // namespace shade16::host
