// Stages 4 and 5 in double precision: coverage by edge functions, colour by barycentric coordinates, depth.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "host_sim/reference/transform.hpp"

namespace shade16::reference {

struct Vertex {
    glm::dvec2 position{};  // pixels from the top left
    double depth = 0;
    glm::dvec3 color{};
};

/// A picture in [0, 1] a channel, before any rounding.
struct Picture {
    int width = 0, height = 0;
    std::vector<glm::dvec3> color{};
    std::vector<double> depth{};
    std::vector<bool> covered{};

    Picture(Viewport viewport, const glm::dvec3& background);
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x); }
};

/// The barycentric coordinates of a point.
glm::dvec3 barycentric(const std::array<glm::dvec2, 3>& corner, const glm::dvec2& p);

/// What a pixel shows of what was interpolated to it, and of where it is.
using Shade = std::function<glm::dvec3(const glm::dvec3& interpolated, const glm::dvec2& pixel)>;

/// Draws a counter-clockwise triangle by the top-left rule; others are culled. Without a Shade the interpolated values are
/// the colours.
void raster(Picture& picture, const std::array<Vertex, 3>& corner, const Shade& shade = {});

}  // namespace shade16::reference
