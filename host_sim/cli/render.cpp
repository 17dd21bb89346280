#include "host_sim/cli/render.hpp"

#include "host_sim/cli/console.hpp"
#include "host_sim/engine/turntable.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "host_sim/model/obj_import.hpp"

namespace shade16::host {

namespace {

int frame_count(const RenderOptions& o) {
    constexpr int frames_of_a_film = 90;
    if (o.frames > 0) return o.frames;
    return o.kind == OutputKind::y4m ? frames_of_a_film : 1;
}

void refuse_what_does_not_fit(const RenderOptions& o) {
    if (o.kind == OutputKind::raw && o.format == Rgb888::name)
        throw input_error(
            "{}: .rgb565 holds 16 bits a pixel, but --format rgb888 has 24; expected --format rgb565 or "
            "rgb565_swapped, or an output such as .png.",
            o.output);
}

std::unique_ptr<Turntable> turntable_of(const ModelScene& scene, const RenderOptions& o) {
    if (o.engine == Engine::reference) return reference_turntable(scene, o.size, o.format);
    return fixed_turntable(scene, o.size, o.tier, o.format, o.band_rows);
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
                    o.size.width, o.size.height);
    if (o.kind == OutputKind::y4m) text += fmt::format(" at {} frames a second; plays with: mpv {}", o.fps, o.output);
    if (o.kind == OutputKind::raw)
        text += fmt::format("; shows with: ffplay -f rawvideo -pixel_format {} -video_size {}x{} {}",
                            o.format == Rgb565Swapped::name ? "rgb565be" : "rgb565le", o.size.width, o.size.height,
                            o.output);
    return text + "\n";
}

}  // namespace

ExitCode render(const RenderOptions& o) {
    refuse_what_does_not_fit(o);
    const ModelScene scene(import_obj(o.model), o.size, o.shading ? &*o.shading : nullptr);
    if (!o.quiet) print_warnings(scene.baked().warnings);
    if (o.verbose) print_beside(o.output, fit_text(scene.figures()));

    const int frames = frame_count(o);
    const auto writer = open_writer(o.output, o.size.width, o.size.height, frames, o.fps);
    const auto turntable = turntable_of(scene, o);
    {
        Progress progress("drawing frame", frames, o.quiet);
        for (int i = 0; i < frames; ++i) {
            progress.begin(i);
            writer->write(turntable->draw(turn_of(i, frames)));
        }
    }
    writer->finish();
    if (!o.quiet && o.kind != OutputKind::png) print_beside(o.output, result_text(o, frames));
    return ExitCode::ok;
}

}  // namespace shade16::host
