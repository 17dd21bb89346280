#include "host_sim/bounds/chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace shade16::bounds {
namespace {

constexpr double left = 76, top = 34, width = 470, height = 210, legend = 176;

double x_px(const Chart& c, double value) { return left + width * c.x.place(value); }
double y_px(const Chart& c, double value) { return top + height * (1 - c.y.place(value)); }

std::string frame(const Chart& c) {
    std::string text = fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>", left, c.title);
    for (const auto& [value, label] : c.y.ticks)
        text += fmt::format(
            "<path class=\"grid\" d=\"M{} {:.1f}h{}\"/><text class=\"tick\" text-anchor=\"end\" x=\"{}\" "
            "y=\"{:.1f}\">{}</text>",
            left, y_px(c, value), width, left - 6, y_px(c, value) + 4, label);
    for (const auto& [value, label] : c.x.ticks)
        text += fmt::format(
            "<path class=\"grid\" d=\"M{:.1f} {}v{}\"/><text class=\"tick\" text-anchor=\"middle\" x=\"{:.1f}\" "
            "y=\"{}\">{}</text>",
            x_px(c, value), top, height, x_px(c, value), top + height + 16, label);
    text += fmt::format("<text class=\"tick\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{}</text>", left + width / 2,
                        top + height + 34, c.x.label);
    return text +
           fmt::format(
               "<text class=\"tick\" text-anchor=\"middle\" transform=\"translate(14 {}) rotate(-90)\">{}</text>",
               top + height / 2, c.y.label);
}

std::string path(const Chart& c, const Line& line, std::size_t color) {
    std::string d;
    for (const auto& [x, y] : line.points)
        d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? 'M' : 'L', x_px(c, x), y_px(c, y));
    return fmt::format("<path class=\"line {}\" d=\"{}\"/>", line.is_bound ? "bound" : fmt::format("c{}", color), d);
}

std::string bars(const Chart& c, const Line& line, std::size_t number, std::size_t of) {
    std::string text;
    const double room = line.points.size() < 2 ? width : x_px(c, line.points[1].first) - x_px(c, line.points[0].first),
                 bar = room / static_cast<double>(of + 1);
    for (const auto& [x, y] : line.points)
        if (const double base = top + height, high = y_px(c, y); high < base)
            text += fmt::format("<rect class=\"fill{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                                number, x_px(c, x) + bar * static_cast<double>(number), high, bar, base - high);
    return text;
}

}  // namespace

double Axis::place(double value) const {
    const auto scaled = [this](double v) { return is_logarithmic ? std::log10(std::max(v, 1e-300)) : v; };
    return std::clamp((scaled(value) - scaled(from)) / (scaled(to) - scaled(from)), 0.0, 1.0);
}

std::vector<std::pair<double, std::string>> decades(double least, double largest) {
    std::vector<std::pair<double, std::string>> ticks;
    for (double v = least; v <= largest * 1.001; v *= 10) ticks.emplace_back(v, fmt::format("{:.4g}", v));
    return ticks;
}

std::vector<std::pair<double, std::string>> even_ticks(double largest, int count) {
    std::vector<std::pair<double, std::string>> ticks;
    for (int i = 0; i <= count; ++i)
        ticks.emplace_back(largest * i / count, fmt::format("{:.3g}", largest * i / count));
    return ticks;
}

std::string svg(const Chart& c) {
    std::string text = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", left + width + legend,
                                   top + height + 44, c.title) +
                       frame(c);
    std::size_t color = 0;
    for (std::size_t i = 0; i < c.lines.size(); ++i) {
        const Line& line = c.lines[i];
        text += c.has_bars ? bars(c, line, i, c.lines.size()) : path(c, line, color);
        const double y = top + 10 + 18 * static_cast<double>(i), x = left + width + 12;
        text += fmt::format("<path class=\"line {}\" d=\"M{} {}h18\"/><text class=\"tick\" x=\"{}\" y=\"{}\">{}</text>",
                            line.is_bound ? "bound" : fmt::format("c{}", color), x, y, x + 24, y + 4, line.name);
        color += !line.is_bound;
    }
    return text + "</svg>\n";
}

}  // namespace shade16::bounds
