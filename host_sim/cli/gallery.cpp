#include "host_sim/cli/gallery.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/error.hpp"
#include "host_sim/gallery/gallery.hpp"
#include "host_sim/gallery/heat_map.hpp"
#include "host_sim/io/frame_writer.hpp"

namespace shade16::host {

namespace {

/// The lines that the page has, in its own form.
std::string figures_text(const Plate& plate) {
    std::string text = plate.file + "\n";
    if (!plate.pairs.empty())
        text +=
            "\n| beside each other | pixels that differ | at least | mean of those | largest "
            "|\n|---|---|---|---|---|\n";
    for (const Pair& p : plate.pairs)
        text += fmt::format("| {} / {} | {:.1f} % | {:.1f} % | {:.1f} levels | {} levels |\n", p.a, p.b,
                            100 * p.difference.share, 100 * p.stated_share, p.difference.mean_levels,
                            p.difference.largest_levels);
    if (std::ranges::none_of(plate.panels, [](const Panel& p) { return p.error.has_value(); })) return text + "\n";
    text += fmt::format(
        "\n| against double precision | mean | largest | beyond {:.2f} levels | beyond {:.1f} levels | one engine "
        "alone |\n"
        "|---|---|---|---|---|---|\n",
        heat_scale_levels, half_code_levels);
    for (const Panel& p : plate.panels)
        if (p.error)
            text +=
                fmt::format("| {} | {:.3f} levels | {:.2f} levels | {} of {} pixels | {} | {} |\n", p.name,
                            p.error->mean_levels, p.error->largest_levels, p.error->beyond(heat_scale_levels),
                            p.error->covered_by_both, p.error->beyond(half_code_levels), p.error->covered_by_one_alone);
    return text + "\n";
}

void write_picture(const std::string& directory, const std::string& name, const Image& image) {
    const std::string path = (std::filesystem::path(directory) / name).string();
    const auto writer = open_writer(path, image.width, image.height, 1, 1);
    writer->write(image);
    writer->finish();
}

void refuse_pairs_alike(const std::vector<Plate>& plates) {
    std::string sentences;
    for (const Plate& plate : plates)
        for (const Pair& p : plate.pairs)
            if (!p.holds())
                sentences += fmt::format("{}{}: '{}' and '{}' differ in {:.1f} % of their pixels; expected at least {:.1f} %.", sentences.empty() ? "" : " ",
                                         plate.file, p.a, p.b, 100 * p.difference.share, 100 * p.stated_share);
    if (!sentences.empty()) throw Error(ExitCode::check, sentences);
}

}  // namespace

ExitCode gallery(const GalleryOptions& o) {
    if (!std::filesystem::is_directory(o.output))
        throw input_error("--output {}: is no directory; expected one that is there, such as docs/gallery.", o.output);
    const std::vector<Plate> plates = gallery_plates(o.assets);
    std::string text;
    for (const Plate& plate : plates) {
        write_picture(o.output, plate.file, plate.image);
        text += figures_text(plate);
    }
    if (o.json)
        print(gallery_json(plates));
    else if (!o.quiet)
        print(text);
    refuse_pairs_alike(plates);
    return ExitCode::ok;
}

}  // namespace shade16::host
