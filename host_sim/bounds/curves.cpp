#include "host_sim/bounds/curves.hpp"

#include <cmath>

#include <fmt/format.h>

#include "host_sim/bounds/float32.hpp"
#include "host_sim/bounds/kernel.hpp"
#include "shade16/num/normalize.hpp"

namespace shade16::bounds {
namespace {

template <class Tier>
double power_error(const Shininess<Tier>& kernel, double n, double u) {
    const double one = std::ldexp(1.0, Kernel<Tier>::u_bits), word = std::min(std::floor(u * one), one - 1);
    const double got = std::ldexp(kernel.power(static_cast<uint32_t>(word)), -Kernel<Tier>::fraction_bits);
    return 255 * std::fabs(got - std::pow(1 - word / one, n));
}

/// The largest error in each of some columns, each a stretch of u = 1 - N.H of equal ratio.
template <class Tier>
Line highlight_line(int exponent) {
    constexpr int columns = 240, samples = 60;
    const auto kernel = shininess<Tier>(Q16::from_int(exponent));
    Line line{fmt::format("n = {}", exponent)};
    for (int i = 0; i < columns; ++i) {
        double worst = 0;
        for (int k = 0; k < samples; ++k)
            worst = larger(worst, power_error<Tier>(kernel, exponent,
                                                    std::pow(10.0, -6 + 6 * (i + k / double{samples}) / columns)));
        line.points.emplace_back(std::pow(10.0, -6 + 6 * (i + 0.5) / columns), worst);
    }
    return line;
}

template <class Tier>
Chart highlight_chart() {
    constexpr double bound = Kernel<Tier>::bound;
    Chart chart{.title = fmt::format("{}: error of (N.H)^n", Tier::name),
                .x = {.label = "N.H",
                      .from = 1e-6,
                      .to = 1,
                      .is_logarithmic = true,
                      .ticks = {{1e-6, "0.999999"},
                                {1e-5, "0.99999"},
                                {1e-4, "0.9999"},
                                {1e-3, "0.999"},
                                {1e-2, "0.99"},
                                {1e-1, "0.9"},
                                {0.5, "0.5"},
                                {1, "0"}}},
                .y = {.label = "levels", .from = 0, .to = bound * 1.1, .ticks = even_ticks(bound, 4)},
                .lines = {{"its share of the promise", {{1e-6, bound}, {1, bound}}, true}}};
    for (const int exponent : {1, 10, 50, 128, 1000}) chart.lines.push_back(highlight_line<Tier>(exponent));
    return chart;
}

template <class Normalize>
Line length_line(const char* name, double unit, Normalize form) {
    Line line{name};
    for (int octave = 0; octave < 32; ++octave) {
        double worst = 0;
        for (uint64_t i = 0; i < 20'000; ++i) {
            Dice dice(static_cast<uint64_t>(octave) << 32 | i);
            const Normal30 d = dice.direction();
            const double length = std::exp2(std::min(octave + dice.uniform(0, 1), 31.0)) * 0x1p-30;
            const auto scaled = [length](Q30 c) { return saturate(std::llround(c.raw * length)); };
            const IVec3 v{scaled(d.x), scaled(d.y), scaled(d.z)}, n = form(v);
            const double x = v.x, y = v.y, z = v.z, exact = std::sqrt(x * x + y * y + z * z);
            if (exact == 0) continue;
            worst = std::fmax(
                worst, std::fmax(std::fabs(n.x * unit - x / exact),
                                 std::fmax(std::fabs(n.y * unit - y / exact), std::fabs(n.z * unit - z / exact))));
        }
        line.points.emplace_back(octave, std::fmax(worst, 1e-12));
    }
    return line;
}

template <class Tier>
double worst_at(int exponent) {
    return search<Tier>({"",
                         "",
                         static_cast<uint64_t>(exponent),
                         {.min_exponent = static_cast<double>(exponent), .max_exponent = static_cast<double>(exponent)},
                         24,
                         6})
        .largest_levels();
}

}  // namespace

std::vector<Chart> highlight_charts() {
    return {highlight_chart<lowp>(), highlight_chart<mediump>(), highlight_chart<highp>()};
}

Chart normalize_chart() {
    Chart chart{
        .title = "Unit vectors: the worst component",
        .x = {.label = "length of the vector, in units of its last place",
              .from = 0,
              .to = 31,
              .ticks = {{0, "1"}, {8, "2^8"}, {16, "2^16"}, {24, "2^24"}, {31, "2^31"}}},
        .y = {.label = "error", .from = 1e-10, .to = 1e-3, .is_logarithmic = true, .ticks = decades(1e-10, 1e-3)}};
    chart.lines = {length_line("normalize14, 49", 0x1p-14, [](IVec3 v) { return raw(normalize14<6>(v)); }),
                   length_line("normalize14, 97", 0x1p-14, [](IVec3 v) { return raw(normalize14<7>(v)); }),
                   length_line("normalize30", 0x1p-30, [](IVec3 v) { return raw(normalize30(v)); }),
                   length_line("normalize_finely", 0x1p-30, [](IVec3 v) { return raw(normalize_finely(v)); })};
    return chart;
}

Chart exponent_chart() {
    Chart chart{.title = "The worst vertex, and a float pipeline's; L near -V included",
                .x = {.label = "exponent n", .from = 1, .to = 1000, .is_logarithmic = true, .ticks = decades(1, 1000)},
                .y = {.label = "levels", .from = 1e-5, .to = 10, .is_logarithmic = true, .ticks = decades(1e-5, 10)},
                .lines = {{"lowp"},
                          {"mediump"},
                          {"highp"},
                          {"float32"},
                          {"one code of RGB565", {{1, 255 / 31.0}, {1000, 255 / 31.0}}, true}}};
    for (const int n : {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1000}) {
        chart.lines[0].points.emplace_back(n, worst_at<lowp>(n));
        chart.lines[1].points.emplace_back(n, worst_at<mediump>(n));
        chart.lines[2].points.emplace_back(n, worst_at<highp>(n));
        const double exponent = n;
        chart.lines[3].points.emplace_back(
            n, search_float32(
                   {"", "", static_cast<uint64_t>(n), {.min_exponent = exponent, .max_exponent = exponent}, 144, 1})
                   .largest_levels());
    }
    return chart;
}

Chart share_chart(const std::vector<VertexResult>& vertices) {
    Chart chart{.title = "Vertices by the share of their bound",
                .x = {.label = "share of the bound that the error takes",
                      .from = 0,
                      .to = 1,
                      .ticks = {{0, "0"}, {0.25, "25 %"}, {0.5, "50 %"}, {0.75, "75 %"}, {1, "100 %"}}},
                .y = {.label = "vertices", .from = 0.5, .to = 1e7, .is_logarithmic = true, .ticks = decades(1, 1e7)},
                .has_bars = true};
    for (const char* tier : {lowp::name, mediump::name, highp::name}) {
        VertexFigures sum;
        for (const VertexResult& v : vertices)
            if (std::string(v.tier) == tier) sum.add(v.figures);
        Line line{tier};
        for (std::size_t i = 0; i < VertexFigures::bins; ++i)
            line.points.emplace_back(static_cast<double>(i) / VertexFigures::bins,
                                     static_cast<double>(sum.histogram()[i]));
        chart.lines.push_back(std::move(line));
    }
    return chart;
}

}  // namespace shade16::bounds
