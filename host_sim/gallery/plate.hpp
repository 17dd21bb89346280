// Plate: one picture of the gallery: panels in rows, each with its words and what stands below it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/gallery/difference.hpp"

namespace shade16::host {

struct Panel {
    std::string name{};
    Image image{};
    std::optional<Image> profile{};              // below it
    std::optional<ReferenceDifference> error{};  // and its heat map below that
    int error_scale = 1;                         // whose pixels are squares of so many
};

/// What a pair of panels must show: that they differ in at least so large a share of their pixels.
struct Pair {
    std::string a{}, b{};
    double stated_share = 0;
    PictureDifference difference{};
    bool holds() const { return difference.share >= stated_share; }
};

struct Plate {
    std::string file{};  // without its directory
    int columns = 1;
    std::vector<Panel> panels{};
    std::vector<Pair> pairs{};
    Image image{};

    /// The panels by these names are a pair, and differ so much.
    void add_pair(const std::string& a, const std::string& b, double stated_share);
};

/// Puts the panels together as the plate's image.
void compose(Plate& plate);

}  // namespace shade16::host
