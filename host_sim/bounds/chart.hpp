// Line charts and bars as inline SVG: no script, no file beside the page.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace shade16::bounds {

struct Axis {
    std::string label{};
    double from = 0, to = 1;
    bool is_logarithmic = false;
    std::vector<std::pair<double, std::string>> ticks{};

    /// Where a value lies, from 0 to 1; held to both ends.
    double place(double value) const;
};

struct Line {
    std::string name{};
    std::vector<std::pair<double, double>> points{};
    bool is_bound = false;  // dashed
};

struct Chart {
    std::string title{};
    Axis x{}, y{};
    std::vector<Line> lines{};
    bool has_bars = false;  // a bar from the axis for each point, of the lines beside each other
};

/// Powers of ten from `least` to `largest`, labelled 0.01, 0.1, 1 ...
std::vector<std::pair<double, std::string>> decades(double least, double largest);
/// `count` equal steps from 0 to `largest`.
std::vector<std::pair<double, std::string>> even_ticks(double largest, int count);

std::string svg(const Chart& chart);

}  // namespace shade16::bounds
