#include "host_sim/cli/show.hpp"

#include <chrono>
#include <thread>

#include "boards/linux_spi/device_gone.hpp"
#include "boards/linux_spi/stop_on_signal.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/engine/turntable.hpp"
#include "host_sim/screen/open_screen.hpp"

namespace shade16::host {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int frames_a_turn = 90;
constexpr std::chrono::seconds patience{1};  // before a device that has gone is looked for again

/// The scene as the screen takes it.
class Film {
public:
    Film(const ShowOptions& o, const Screen& screen)
        : open_(open_scene(o.scene, screen.size())),
          turntable_(fixed_turntable(*open_.scene, screen.size(), o.scene.tier, {screen.format(), o.scene.dither.value_or(dither_names[0])}, 0, o.scene.component)) {
        print_warnings(open_.scene->warnings());
    }
    Image frame(int number) { return turntable_->draw(turn_of(number % frames_a_turn, frames_a_turn)); }

private:
    OpenScene open_;
    std::unique_ptr<Turntable> turntable_;
};

double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

std::string figures_text(const ScreenFigures& f, Clock::duration time, std::size_t lost) {
    if (f.frames == 0) return "shown: no frame\n";
    std::string text = fmt::format("shown: {} frames in {:.1f} s, {:.1f} a second; {} bytes of pixels a frame; sending took {:.0f} % of the time\n", f.frames, seconds(time),
                                   static_cast<double>(f.frames) / seconds(time), f.bytes / f.frames, 100 * seconds(f.sending) / seconds(time));
    if (lost != 0) text += fmt::format("lost: {} frames, while the device had gone\n", lost);
    return text;
}

/// Frame after frame until enough are shown or somebody stops it. What the device loses by going is shown anew when it is back.
class Show {
public:
    explicit Show(const ShowOptions& o) : o_(o), screen_(open_screen(o.screen)), film_(o, *screen_) {}

    /// The signal that ended it, or 0.
    int run() {
        const auto begin = Clock::now();
        auto due = begin;
        for (int number = 0; !is_asked() && (o_.frames == 0 || number < o_.frames); ++number) {
            show(film_.frame(number));
            due = std::max(due + std::chrono::microseconds(1'000'000 / o_.fps), Clock::now());
            if (o_.frames == 0 || number + 1 < o_.frames) wait_until(due);
        }
        if (screen_) add(screen_->figures());
        if (screen_ && o_.screen.off_at_end) screen_->switch_off();
        screen_.reset();
        if (!o_.quiet) print_beside(o_.screen.takes_stdout() ? "-" : "", figures_text(sum_, Clock::now() - begin, lost_));
        return stop_.asked();
    }

private:
    void show(const Image& frame) {
        try {
            if (!screen_) screen_ = open_screen(o_.screen);
            screen_->show(frame);
        } catch (const linux_spi::DeviceGone& gone) {
            if (screen_) add(screen_->figures());
            screen_.reset();
            if (lost_++ == 0 || !was_gone_) print_warnings({gone.what()});
            was_gone_ = true;
            wait_until(Clock::now() + patience);
            return;
        }
        was_gone_ = false;
    }
    bool is_asked() const { return stop_.asked() != 0; }
    void wait_until(Clock::time_point time) const {
        constexpr std::chrono::milliseconds glance{10};
        while (!is_asked() && Clock::now() + glance < time) std::this_thread::sleep_for(glance);
        if (!is_asked()) std::this_thread::sleep_until(time);
    }
    void add(const ScreenFigures& f) { sum_.frames += f.frames, sum_.bytes += f.bytes, sum_.sending += f.sending; }

    const ShowOptions& o_;
    linux_spi::StopOnSignal stop_{};
    std::unique_ptr<Screen> screen_;
    Film film_;
    ScreenFigures sum_{};
    std::size_t lost_ = 0;
    bool was_gone_ = false;
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
    // Lines are released and the terminal is as it was; a shell sees what ended it.
    if (const int signal = Show(o).run(); signal != 0) linux_spi::end_by({signal});
    return ExitCode::ok;
}

}  // namespace shade16::host
