#include "host_sim/cli/render.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/engine/turntable.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "host_sim/io/magnify.hpp"

namespace shade16::host {

namespace {

int frame_count(const RenderOptions& o) {
    constexpr int frames_of_a_film = 90;
    if (o.frames > 0) return o.frames;
    return o.kind == OutputKind::y4m || o.kind == OutputKind::apng ? frames_of_a_film : 1;
}

/// What a raw file's ending says, against the format.
void refuse_another_raw_format(const RenderOptions& o) {
    const std::string ending = std::filesystem::path(o.output).extension().string().substr(1);
    const auto in_lower_case = [](char a, char b) { return ('A' <= a && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
    const auto is = [&](std::string_view name) { return std::ranges::equal(ending, name, in_lower_case); };
    const std::string& format = o.target.format;
    if (is(Rgb565::name) && format == Rgb888::name)
        throw input_error(
            "{}: .rgb565 holds 16 bits a pixel, but --format rgb888 has 24; expected --format rgb565 or "
            "rgb565_swapped, or an output such as .png.",
            o.output);
    if (is(format) || (is(Rgb565::name) && format == Rgb565Swapped::name)) return;
    if (format == Rgb888::name)
        throw input_error("{}: rgb888 has no raw file; expected --format {}, or an output such as .png.", o.output,
                          ending);
    throw input_error("{}: the ending is not that of --format {}; expected .{}.", o.output, format,
                      is_gray(format) ? format : Rgb565::name);
}

void refuse_what_does_not_fit(const RenderOptions& o) {
    with_target(o.target, [](auto) {});  // refuses what can not be dithered
    if (o.kind == OutputKind::raw) refuse_another_raw_format(o);
    constexpr int max_output_px = 8192;
    if (const int longest = o.scale * std::max(o.size.width, o.size.height); longest > max_output_px)
        throw input_error("--scale {}: makes {} pixels of {}; expected at most {}.", o.scale, longest,
                          longest / o.scale, max_output_px);
}

std::unique_ptr<Turntable> turntable_of(const AnimatedScene& scene, const RenderOptions& o) {
    if (o.engine == Engine::reference) return reference_turntable(scene, o.size, o.target, o.component);
    return fixed_turntable(scene, o.size, o.tier, o.target, o.band_rows, o.component);
}

std::string fit_text(const FitFigures& fit) {
    return fmt::format(
        "fit: the model covers {:.0f} to {:.0f} % of the frame's width or height (the larger of both) over a turn\n"
        "fit: the brightest code is {} of 255\n"
        "fit: at most {:.2f} % of the model's pixels are saturated\n",
        100 * fit.least_cover, 100 * fit.largest_cover, fit.brightest_code, 100 * fit.saturated_share);
}

const char* pixel_format_of_ffmpeg(const std::string& format) {
    return format == Rgb565Swapped::name ? "rgb565be"
           : format == Gray8::name       ? "gray"
           : format == Mono1::name       ? "monob"
                                         : "rgb565le";
}

std::string result_text(const RenderOptions& o, int frames) {
    std::string text =
        fmt::format("{}: {} of {}x{} pixels", o.output, counted(static_cast<std::size_t>(frames), "frame", "frames"),
                    o.size.width * o.scale, o.size.height * o.scale);
    if (o.kind == OutputKind::y4m) text += fmt::format(" at {} frames a second; plays with: mpv {}", o.fps, o.output);
    if (o.kind == OutputKind::apng) text += fmt::format(" at {} frames a second; a web browser plays it", o.fps);
    if (o.kind == OutputKind::png) text += fmt::format(", numbered from -{:04} to -{:04}", 0, frames - 1);
    if (o.kind == OutputKind::raw && o.target.format == Gray4::name)
        text += fmt::format("; two pixels a byte, {} bytes a row", (o.size.width * o.scale + 1) / 2);
    else if (o.kind == OutputKind::raw)
        text += fmt::format("; shows with: ffplay -f rawvideo -pixel_format {} -video_size {}x{} {}",
                            pixel_format_of_ffmpeg(o.target.format), o.size.width * o.scale,
                            o.size.height * o.scale, o.output);
    return text + "\n";
}

}  // namespace

ExitCode render(const RenderOptions& options) {
    RenderOptions o = options;
    const OpenScene open = open_scene(o);
    const AnimatedScene& scene = *open.scene;
    refuse_what_does_not_fit(o);
    if (!o.quiet) print_warnings(scene.warnings());
    if (o.dump_scene) {
        print(dumped(open, o));
        return ExitCode::ok;
    }
    if (o.verbose && !o.json && open.fit) print_beside(o.output, fit_text(*open.fit));

    const int frames = frame_count(o);
    const auto writer = open_writer(o.output, o.size.width * o.scale, o.size.height * o.scale, frames, o.fps);
    const auto turntable = turntable_of(scene, o);
    {
        Progress progress("drawing frame", frames, o.quiet);
        for (int i = 0; i < frames; ++i) {
            progress.begin(i);
            writer->write(magnified(turntable->draw(turn_of(i, frames)), o.scale));
        }
    }
    writer->finish();
    if (o.json) print_beside(o.output, render_json(o, open.fit ? &*open.fit : nullptr, frames, scene.warnings()));
    else if (!o.quiet && (o.kind != OutputKind::png || frames > 1)) print_beside(o.output, result_text(o, frames));
    return ExitCode::ok;
}

}  // namespace shade16::host
