#include "host_sim/cli/render.hpp"

#include <algorithm>

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

void refuse_what_does_not_fit(const RenderOptions& o) {
    if (o.kind == OutputKind::raw && o.format == Rgb888::name)
        throw input_error(
            "{}: .rgb565 holds 16 bits a pixel, but --format rgb888 has 24; expected --format rgb565 or "
            "rgb565_swapped, or an output such as .png.",
            o.output);
    constexpr int max_output_px = 8192;
    if (const int longest = o.scale * std::max(o.size.width, o.size.height); longest > max_output_px)
        throw input_error("--scale {}: makes {} pixels of {}; expected at most {}.", o.scale, longest,
                          longest / o.scale, max_output_px);
}

std::unique_ptr<Turntable> turntable_of(const AnimatedScene& scene, const RenderOptions& o) {
    if (o.engine == Engine::reference) return reference_turntable(scene, o.size, o.format, o.component);
    return fixed_turntable(scene, o.size, o.tier, o.format, o.band_rows, o.component);
}

std::string fit_text(const FitFigures& fit) {
    return fmt::format(
        "fit: the model covers {:.0f} to {:.0f} % of the frame's width or height (the larger of both) over a turn\n"
        "fit: the brightest code is {} of 255\n"
        "fit: at most {:.2f} % of the model's pixels are saturated\n",
        100 * fit.least_cover, 100 * fit.largest_cover, fit.brightest_code, 100 * fit.saturated_share);
}

std::string result_text(const RenderOptions& o, int frames) {
    std::string text =
        fmt::format("{}: {} of {}x{} pixels", o.output, counted(static_cast<std::size_t>(frames), "frame", "frames"),
                    o.size.width * o.scale, o.size.height * o.scale);
    if (o.kind == OutputKind::y4m) text += fmt::format(" at {} frames a second; plays with: mpv {}", o.fps, o.output);
    if (o.kind == OutputKind::apng) text += fmt::format(" at {} frames a second; a web browser plays it", o.fps);
    if (o.kind == OutputKind::png) text += fmt::format(", numbered from -{:04} to -{:04}", 0, frames - 1);
    if (o.kind == OutputKind::raw)
        text += fmt::format("; shows with: ffplay -f rawvideo -pixel_format {} -video_size {}x{} {}",
                            o.format == Rgb565Swapped::name ? "rgb565be" : "rgb565le", o.size.width * o.scale,
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
