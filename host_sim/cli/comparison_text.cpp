#include "host_sim/cli/comparison_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "host_sim/cli/console.hpp"
#include "host_sim/engine/formats.hpp"
#include "host_sim/report/judge.hpp"

namespace shade16::host {

namespace {

std::string display_name(const Comparison& c) { return c.format == Rgb565::name ? "RGB565" : c.format; }

std::string row(const Comparison& c, const ErrorFigures& figures, const std::string& promised, const Ink& ink) {
    return fmt::format("    {:<9}{:<21}{:>9.5f} {:>9.5f} {:>8.1f} %    {}\n", c.tier, promised, figures.largest,
                       figures.mean(), 100 * figures.largest_of_bound,
                       figures.holds() ? ink.good("kept") : ink.bad("BROKEN"));
}

constexpr const char* heading = "    tier     promised (levels)      largest      mean   of bound    verdict\n";

std::string vertices_text(const std::vector<Comparison>& tiers, const Ink& ink) {
    std::string text =
        "(i) Lit vertices (faces, where shading is flat), against double precision on the same integers\n";
    text += heading;
    for (const Comparison& c : tiers)
        text += row(c, c.vertices, fmt::format("{:g}; {:g}", c.promise_to_128, c.promise_to_1000), ink);
    return text +
           fmt::format(
               "    Promised for one light of intensity 1: with shininess up to 128; up to 1000. Lights add up.\n"
               "    {} compared in each tier.\n\n",
               counted(tiers.front().vertices.count, "point", "points"));
}

std::string pixels_text(const std::vector<Comparison>& tiers, const Ink& ink) {
    std::string text = "(ii) Pixels before they are rounded to the display's format: (i) and stepping along a row, or light by pixel\n";
    text += heading;
    for (const Comparison& c : tiers)
        text += row(c, c.pixels, fmt::format("as above + {:.2g}", c.stepping_levels), ink);
    for (const Comparison& c : tiers)
        if (c.tables.count > 0) text += row(c, c.tables, "a light table's own", ink);
    if (tiers.front().tables.count > 0)
        text += "    A light table is a policy with a bound of its own: it holds neither mediump's promise nor lowp's.\n";
    for (const Comparison& c : tiers)
        if (c.textured_pixels > 0)
            text += fmt::format("    {:<9}{} of {} textured pixels show the texel beside the exact one\n", c.tier, c.other_texel,
                                c.textured_pixels);
    return text + fmt::format("    {} of triangles cut by the frame's edges or the camera were left out.\n\n",
                              counted(tiers.front().clipped_pixels, "pixel", "pixels"));
}

std::string picture_text(const std::vector<Comparison>& tiers) {
    const Comparison& first = tiers.front();
    std::string text =
        fmt::format("(iii) The finished {} picture, against an independent one of the unrounded model\n", display_name(first));
    text += "    tier     promised               largest      mean   covered in only one of both\n";
    for (const Comparison& c : tiers)
        text +=
            fmt::format("    {:<9}{:<21}{:>9.5f} {:>9.5f}   {} of {} pixels\n", c.tier, "nothing", c.picture.largest,
                        c.picture.mean(), c.covered_by_one, c.covered_by_one + c.covered_by_both);
    if (is_gray(first.format))
        return text + fmt::format(
                          "    Most of it is the display's own rounding: one code of {} is {:.1f} levels, so rounding alone\n"
                          "    takes up to {:.1f}. The largest are beside edges, where the two pictures may show different\n"
                          "    faces.\n\n",
                          first.format, first.widest_code_levels, first.widest_code_levels / 2);
    return text +
           fmt::format(
               "    Most of it is the display's own rounding: one code of RGB565 is {:.1f} levels in red and blue\n"
               "    and {:.1f} in green, so rounding alone takes up to {:.1f}. The largest are beside edges, where\n"
               "    the two pictures may show different faces.\n\n",
               first.widest_code_levels, first.narrowest_code_levels, first.widest_code_levels / 2);
}

std::string verdict_text(const std::string& verdict, const Ink& ink) {
    if (verdict == "broken") return "Verdict: " + ink.bad("BROKEN") + ". An error is larger than promised.\n";
    if (verdict == "suspect")
        return "Verdict: " + ink.bad("SUSPECT") + ". The reference never differs, so it is not compared with.\n";
    return "Verdict: " + ink.good("every promise is kept") + ".\n";
}

}  // namespace

const char* verdict_of(const std::vector<Comparison>& tiers) {
    const auto any = [&](auto is) { return std::any_of(tiers.begin(), tiers.end(), is); };
    if (any([](const Comparison& c) { return !c.vertices.holds() || !c.pixels.holds() || !c.tables.holds(); })) return "broken";
    return any([](const Comparison& c) { return !c.holds(); }) ? "suspect" : "kept";
}

std::string comparison_text(const std::vector<Comparison>& tiers, const AnimatedScene& scene, const CompareOptions& o,
                            const Ink& ink) {
    const std::string what = fmt::format("{}: {}, {}; {} of {}x{} pixels over one turn, {} lights.\n", scene.source(),
                                         counted(vertex_count(scene.scene()), "vertex", "vertices"),
                                         counted(triangle_count(scene.scene()), "triangle", "triangles"),
                                         counted(static_cast<std::size_t>(o.frames), "frame", "frames"), o.size.width,
                                         o.size.height, scene.scene().lights.count);
    const std::string units =
        "Errors are in levels: one level is 1/255 of a colour channel. 'Of bound' is the largest share that an error\n"
        "took of what is promised at its own point, with its own lights: up to 100 % the promise is kept.\n\n";
    return what + units + vertices_text(tiers, ink) + pixels_text(tiers, ink) + picture_text(tiers) +
           verdict_text(verdict_of(tiers), ink);
}

}  // namespace shade16::host
