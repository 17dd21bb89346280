#include "host_sim/cli/show.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "boards/linux_spi/stop_on_signal.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/cli/open_screen.hpp"
#include "host_sim/cli/show_figures.hpp"
#include "host_sim/cli/terminal.hpp"
#include "host_sim/engine/turntable.hpp"
#include "host_sim/screen/lasting_screen.hpp"
#include "host_sim/screen/panel_by_name.hpp"

namespace shade16::host {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int frames_a_turn = 90;
constexpr std::chrono::seconds patience{1};  // before a device that has gone is looked for again

/// A grey scene file is shown as its display would where the screen takes that; everything else in full colour, unless somebody asks.
TargetFormat any_target_of(const PreviewOptions& o, const TargetFormat& of_file) {
    const TargetFormat usual = is_gray(of_file.format) ? of_file : TargetFormat{Rgb888::name, dither_names[0]};
    const std::string format = o.format.value_or(usual.format);
    return {format, o.dither.value_or(o.format ? dither_names[0] : usual.dither)};
}

/// The scene as a screen of some size and format takes it.
class Film {
public:
    Film(const PreviewOptions& o, Viewport size, const char* format)
        : size_(size),
          open_(open_scene(o, size)),
          turntable_(fixed_turntable(*open_.scene, size, o.tier, target_of(o, format), 0, o.component)) {}

    bool fits(Viewport size) const { return size.width == size_.width && size.height == size_.height; }
    Image frame(int number) { return turntable_->draw(turn_of(number, frames_a_turn)); }
    const std::vector<std::string>& warnings() const { return open_.scene->warnings(); }

private:
    TargetFormat target_of(const PreviewOptions& o, const char* format) const {
        if (format == nullptr) return any_target_of(o, open_.description.output.target);
        return {format, o.dither.value_or(dither_names[0])};
    }
    Viewport size_;
    OpenScene open_;
    std::unique_ptr<Turntable> turntable_;
};

/// Frame after frame until enough are shown or somebody stops it.
class Show {
public:
    explicit Show(const ShowOptions& o) : o_(o), screen_([&o] { return open_screen(o.screen); }) {
        refit();
        print_warnings(film_->warnings());
        const bool is_file = o.screen.kind == ScreenKind::terminal && !is_terminal(STDOUT_FILENO);
        frames_ = is_file && o.scene.frames == 0 ? 1 : o.scene.frames;  // a file would never end
    }

    /// The signal that ended it, or 0.
    int run() {
        const auto begin = Clock::now();
        auto due = begin;
        for (int64_t number = 0; !is_ended(); ++number) {
            refit();
            show(film_->frame(static_cast<int>(number % frames_a_turn)));
            if (number + 1 == frames_) break;
            due = std::max(due + std::chrono::microseconds(1'000'000 / o_.fps), Clock::now());
            wait_until(due);
        }
        live_.clear();
        if (o_.screen.wires.is_dark_at_end) switch_off();
        screen_.close();
        const std::string figures = figures_text(screen_.figures(), Clock::now() - begin, screen_.lost());
        if (!o_.quiet) print_beside(o_.screen.takes_stdout() ? "-" : "", figures);
        return stop_.asked();
    }

private:
    void refit() {
        const Screen* const screen = screen_.screen();
        if (screen != nullptr && !(film_ && film_->fits(screen->size()))) film_.emplace(o_.scene, screen->size(), screen->format());
    }
    void show(const Image& frame) {
        const bool was_away = screen_.screen() == nullptr;
        if (screen_.show(frame)) {
            if (was_away && !o_.quiet) print_beside("-", "the device is back\n");
            live_.tell(screen_.figures());
            return;
        }
        live_.clear();
        if (!was_away || screen_.reason() != reason_) print_warnings({screen_.reason()});
        reason_ = screen_.reason();
        wait_until(Clock::now() + patience);
    }
    void switch_off() {
        try {
            if (Screen* const screen = screen_.screen()) screen->switch_off();
        } catch (const Error& error) {  // it has gone by itself
            print_warnings({error.what()});
        }
    }
    bool is_ended() const { return has_quit_ || stop_.asked() != 0; }
    void wait_until(Clock::time_point time) {
        constexpr std::chrono::milliseconds glance{10};  // a signal that comes between a look and a sleep waits no longer than this
        const bool has_keys = o_.screen.kind == ScreenKind::terminal && is_terminal(STDOUT_FILENO);
        if (has_keys) has_quit_ = is_quit_typed(0);  // also where drawing leaves no time
        for (auto now = Clock::now(); !is_ended() && now < time; now = Clock::now()) {
            const auto pause = std::min<Clock::duration>(glance, time - now);
            if (has_keys)
                has_quit_ = is_quit_typed(static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(pause).count()));
            else
                std::this_thread::sleep_for(pause);
        }
    }

    const ShowOptions& o_;
    linux_spi::StopOnSignal stop_{};
    LastingScreen screen_;
    std::optional<Film> film_{};
    LiveFigures live_{!o_.quiet && o_.screen.kind == ScreenKind::linux_spi && !(o_.screen.dry_run && is_terminal(STDOUT_FILENO))};  // not in a picture
    std::string reason_{};  // the last that was told
    int frames_ = 0;  // 0: until somebody ends it
    bool has_quit_ = false;
};

}  // namespace

ExitCode show(const ShowOptions& o) {
    if (o.lists_panels) {
        print(panels_text());
        return ExitCode::ok;
    }
    if (o.probes) {
        const Probe found = probe(o.screen);
        print(found.text);
        return found.is_ready ? ExitCode::ok : ExitCode::check;
    }
    if (o.screen.kind == ScreenKind::linux_spi) open_scene(o.scene, {64, 64});  // a mistake in it switches no panel on
    // By now lines are released and the terminal is as it was; a shell sees what ended it.
    if (const int signal = Show(o).run(); signal != 0) linux_spi::end_by({signal});
    return ExitCode::ok;
}

}  // namespace shade16::host
