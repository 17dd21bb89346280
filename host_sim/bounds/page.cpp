#include "host_sim/bounds/page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "host_sim/bounds/curves.hpp"

namespace shade16::bounds {
namespace {

constexpr const char* style = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>shade16: bounds</title>
<style>
:root{--paper:#fff;--ink:#1c2430;--soft:#5b6775;--line:#d8dee6;--good:#17733f;--bad:#b3261e;--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#aa4499;--c4:#9a7b00}
@media (prefers-color-scheme:dark){:root{--paper:#12161c;--ink:#e6eaf0;--soft:#9aa7b6;--line:#2c3541;--good:#5fd08f;--bad:#ff8a80;--c0:#56b4e9;--c1:#ff9a4d;--c2:#3ecfa0;--c3:#e090d0;--c4:#e0c040}}
body{background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,sans-serif;max-width:1380px;margin:0 auto;padding:1.5rem}
h1,h2{line-height:1.2}.lead{color:var(--soft);max-width:70ch}.verdict{font-weight:600}.kept{color:var(--good)}.broken{color:var(--bad)}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,560px),1fr));gap:1rem}svg{width:100%;height:auto}
.title{font:600 14px system-ui,sans-serif;fill:var(--ink)}.tick{font:11px system-ui,sans-serif;fill:var(--soft)}.grid{stroke:var(--line);fill:none}
.line{fill:none;stroke-width:1.6}.bound{stroke:var(--bad);stroke-dasharray:6 4}
.c0{stroke:var(--c0)}.c1{stroke:var(--c1)}.c2{stroke:var(--c2)}.c3{stroke:var(--c3)}.c4{stroke:var(--c4)}.fill0{fill:var(--c0)}.fill1{fill:var(--c1)}.fill2{fill:var(--c2)}
.scroll{overflow-x:auto}table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}th,td{padding:.25rem .6rem;border-bottom:1px solid var(--line);text-align:left;white-space:nowrap}
th{color:var(--soft);font-weight:600}td.n,th.n{text-align:right}.meter{display:inline-block;width:80px;height:8px;background:var(--line);border-radius:4px;margin-right:.5rem;vertical-align:middle}
.meter i{display:block;height:8px;border-radius:4px;background:var(--c0)}
</style></head><body>
)";

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return safe;
}

std::string looked_at(const Result& r) { return with_commas(r.inputs) + (r.is_exhaustive() ? ", all" : ""); }

std::string row(const Result& r) {
    const double share = r.bound == 0 ? 0 : r.measured / r.bound;
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td><td><span "
        "class=\"meter\"><i style=\"width:{:.0f}%\"></i></span>{}</td><td class=\"n\">{}</td>"
        "<td class=\"{}</td></tr>\n",
        escaped(r.name), r.tier, figure(r.bound), figure(r.measured), escaped(r.unit), 100 * std::min(share, 1.0),
        r.bound == 0 ? "exact" : fmt::format("{:.1f} %", 100 * share), looked_at(r),
        r.holds() ? "kept\">kept" : "broken\">broken");
}

std::string figure_chart(const Chart& chart) { return "<figure style=\"margin:0\">" + svg(chart) + "</figure>\n"; }

std::string vertex_row(const VertexResult& v) {
    const VertexFigures& f = v.figures;
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{:.1f} %</td><td class=\"n\">{:.2f} %</td><td class=\"n\">{:.2f} %</td><td "
        "class=\"n\">{}</td></tr>\n",
        escaped(v.domain.name), v.tier, figure(f.largest_levels()), figure(f.usual_levels()), figure(f.mean_levels()),
        100 * f.largest_share(), 100 * f.exact_at_8_bits(), 100 * f.exact_at_565(), with_commas(f.vertices()));
}

/// What rounding to a display's codes errs by itself, so that nobody is misled.
struct Rounding {
    const char* format;
    double code_levels;
};
constexpr Rounding roundings[] = {{"RGB888, Gray8", 1},
                                  {"RGB565, green", 255 / 63.0},
                                  {"RGB565, red and blue", 255 / 31.0},
                                  {"Gray4", 17},
                                  {"Mono1", 255}};

/// The lines of a chart as the columns of a table.
std::string table(const Chart& chart) {
    std::vector<Line> lines;
    for (const Line& line : chart.lines)
        if (!line.is_bound) lines.push_back(line);
    std::string text = "| " + chart.x.label + " |", rule = "|---|";
    for (const Line& line : lines) text += " " + line.name + " |", rule += "---|";
    text += "\n" + rule + "\n";
    for (std::size_t i = 0; i < lines.front().points.size(); ++i) {
        text += "| " + figure(lines.front().points[i].first) + " |";
        for (const Line& line : lines) text += " " + figure(line.points[i].second) + " |";
        text += "\n";
    }
    return text;
}

std::string vertex_tables(const std::vector<VertexResult>& vertices) {
    std::string text =
        "| scenes | tier | largest | 99.9 % | mean | of its promise | exact at 8 bits | exact at RGB565 | vertices "
        "|\n|---|---|---|---|---|---|---|---|---|\n";
    for (const VertexResult& v : vertices) {
        const VertexFigures& f = v.figures;
        text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} % | {:.2f} % | {:.2f} % | {} |\n", v.domain.name, v.tier,
                            figure(f.largest_levels()), figure(f.usual_levels()), figure(f.mean_levels()),
                            100 * f.largest_share(), 100 * f.exact_at_8_bits(), 100 * f.exact_at_565(),
                            with_commas(f.vertices()));
    }
    const Chart exponents = exponent_chart();
    return text + "\n" + exponents.title + ", in levels:\n\n" + table(exponents) + "\n";
}

}  // namespace

std::string page(const Report& report) {
    const auto& [results, vertices] = report;
    const auto broken = std::ranges::count_if(results, [](const Result& r) { return !r.holds(); });
    std::string text = style;
    text +=
        "<h1>shade16: what it promises, and what was measured</h1>\n<p class=\"lead\">Every function that errs has a "
        "bound, a constant in its header. Here each is held against double precision or wider; "
        "what is exact has the bound 0. A level is 1/255 of a colour channel.</p>\n";
    text += fmt::format("<p class=\"verdict {}</p>\n",
                        broken == 0 ? fmt::format("kept\">All {} bounds are kept.", results.size())
                                    : fmt::format("broken\">{} of {} bounds are broken.", broken, results.size()));
    text += "<div class=\"charts\">\n";
    for (const Chart& chart : highlight_charts()) text += figure_chart(chart);
    text += figure_chart(normalize_chart());
    if (!vertices.empty()) text += figure_chart(exponent_chart()) + figure_chart(share_chart(vertices));
    text += "</div>\n";
    if (!vertices.empty()) {
        text +=
            "<h2>Whole vertices</h2>\n<p class=\"lead\">Searched with restarts and hill climbing. A promise is for a "
            "light that arrives at 1 with |L + V| from 0.5: where lamps arrive at more, or L is near -V, more is "
            "allowed, and the share of the promise is what counts. Exact: channels that get the code that double "
            "precision gets.</p>\n"
            "<div class=\"scroll\"><table><tr><th>scenes</th><th>tier</th><th class=\"n\">largest, levels</th><th "
            "class=\"n\">99.9 %</th><th class=\"n\">mean</th><th class=\"n\">of its promise</th><th class=\"n\">exact "
            "at 8 bits</th><th class=\"n\">at RGB565</th><th class=\"n\">vertices</th></tr>\n";
        for (const VertexResult& v : vertices) text += vertex_row(v);
        text += "</table></div>\n";
    }
    text +=
        "<h2>The display's own rounding</h2>\n<div class=\"scroll\"><table><tr><th>format</th><th class=\"n\">one "
        "code, levels</th><th class=\"n\">rounding errs by at most</th></tr>\n";
    for (const Rounding& r : roundings)
        text += fmt::format("<tr><td>{}</td><td class=\"n\">{:.3g}</td><td class=\"n\">{:.3g}</td></tr>\n", r.format,
                            r.code_levels, r.code_levels / 2);
    text +=
        "</table></div>\n<h2>Every function</h2>\n<div class=\"scroll\"><table><tr><th>function</th><th>tier</th><th "
        "class=\"n\">bound</th><th class=\"n\">measured</th><th>unit</th><th>share</th><th "
        "class=\"n\">inputs</th><th>verdict</th></tr>\n";
    for (const Result& r : results) text += row(r);
    return text + "</table></div>\n</body></html>\n";
}

std::string markdown(const Report& report) {
    const auto& [results, vertices] = report;
    std::string text = vertices.empty() ? "" : vertex_tables(vertices);
    text += "| function | tier | bound | measured | unit | inputs |\n|---|---|---|---|---|---|\n";
    for (const Result& r : results)
        if (vertices.empty() || !r.name.starts_with("vertex: "))
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", r.name, r.tier, figure(r.bound),
                                figure(r.measured), r.unit, looked_at(r));
    return text;
}

}  // namespace shade16::bounds
