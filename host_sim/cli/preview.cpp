#include "host_sim/cli/preview.hpp"

#include <chrono>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/half_blocks.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/cli/terminal.hpp"
#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/turntable.hpp"

namespace shade16::host {

namespace {

constexpr int frames_a_turn = 90;
constexpr std::chrono::milliseconds frame_time{33};

/// A grey scene file is shown as its display would; everything else in full colour, unless somebody asks.
TargetFormat target_of(const PreviewOptions& o, const TargetFormat& of_file) {
    const TargetFormat usual = is_gray(of_file.format) ? of_file : TargetFormat{Rgb888::name, dither_names[0]};
    const std::string format = o.format.value_or(usual.format);
    return {format, o.dither.value_or(o.format ? dither_names[0] : usual.dither)};
}

/// What is to be seen, as large as the terminal is now.
struct Shown {
    Shown(const PreviewOptions& o, Viewport viewport)
        : size(viewport),
          open(open_scene(o, viewport)),
          turntable(fixed_turntable(*open.scene, viewport, o.tier, target_of(o, open.description.output.target), 0, o.component)) {}

    std::string text(int frame) {
        const Image image = turntable->draw(turn_of(frame % frames_a_turn, frames_a_turn));
        return wants_no_color() ? shades_of_letters(image) : half_blocks(image);
    }

    Viewport size;
    OpenScene open;
    std::unique_ptr<Turntable> turntable;
};

bool same(Viewport a, Viewport b) { return a.width == b.width && a.height == b.height; }

/// Without the last line's end, which would scroll a full screen.
std::string without_last_end(std::string text) {
    text.pop_back();
    return text;
}

/// Draws over the frame before, until 'q' or the last frame; a signal ends it, too.
void play(const PreviewOptions& o, std::unique_ptr<Shown> shown) {
    const TerminalHeld held;
    auto due = std::chrono::steady_clock::now();
    std::string beginning = "";
    for (int frame = 0; o.frames == 0 || frame < o.frames; ++frame) {
        if (const Viewport now = pixels_of_terminal(); !same(now, shown->size)) {
            shown = std::make_unique<Shown>(o, now);
            beginning = "\033[0m\033[2J\033[H";  // resized: what is there no longer fits
        }
        print(beginning + without_last_end(shown->text(frame)));
        beginning = shown->size.height > 2 ? fmt::format("\r\033[{}A", shown->size.height / 2 - 1) : "\r";
        if (frame + 1 == o.frames) return;

        due = std::max(due + frame_time, std::chrono::steady_clock::now());
        const auto wait = std::chrono::duration_cast<std::chrono::milliseconds>(due - std::chrono::steady_clock::now());
        if (is_quit_typed(static_cast<int>(wait.count()))) return;
    }
}

}  // namespace

ExitCode preview(const PreviewOptions& o) {
    auto shown = std::make_unique<Shown>(o, pixels_of_terminal());
    print_warnings(shown->open.scene->warnings());
    if (is_terminal(STDOUT_FILENO))
        play(o, std::move(shown));
    else
        print(shown->text(0));
    return ExitCode::ok;
}

}  // namespace shade16::host
