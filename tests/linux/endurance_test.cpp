// A hundred thousand frames through a kernel that interrupts, puts off, cuts short and takes the device away: what is said to be shown is
// shown, what is lost is counted, and nothing is held that should not be.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "host_sim/screen/lasting_screen.hpp"
#include "host_sim/screen/wired_screen.hpp"
#include "tests/linux/fake_chips.hpp"
#include "tests/linux/kernel_model.hpp"
#include "tests/linux/small_panel.hpp"

namespace shade16::linux_spi {
namespace {

struct Counts {
    int shown = 0, lost = 0, interrupted = 0, put_off = 0, cut_short = 0, device_gone = 0, lines_gone = 0, power_lost = 0;
    std::string text() const {
        return "shown " + std::to_string(shown) + ", lost " + std::to_string(lost) + "; interrupted " + std::to_string(interrupted) + ", put off " + std::to_string(put_off) +
               ", cut short " + std::to_string(cut_short) + "; the device gone " + std::to_string(device_gone) + " times, the lines " + std::to_string(lines_gone) +
               ", the panel's supply " + std::to_string(power_lost);
    }
};

class Endurance : public FakeChips {
protected:
    Endurance() {
        kernel_.fate = [this](std::size_t bytes) { return fate(bytes); };
    }
    int one_of(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

    int fate(std::size_t bytes) {
        const int chance = one_of(10'000);
        if (chance < 100) return ++counts_.interrupted, -EINTR;
        if (chance < 200) return ++counts_.put_off, -EAGAIN;
        if (chance < 300) return ++counts_.cut_short, 1 + one_of(static_cast<int>(bytes));
        if (chance >= 305) return static_cast<int>(bytes);
        ++counts_.device_gone;
        kernel_.take_away(), frames_away_ = 1 + one_of(4);
        return -ENODEV;
    }
    /// Between two frames somebody pulls the lines' chip, or puts things back.
    void pass_time() {
        FakeChip& lines = fake.chips.at("gpiochip0");
        if (frames_away_ == 0 && one_of(300) == 0) ++counts_.lines_gone, ++lines.removals, lines.gone = true, frames_away_ = 1 + one_of(4);
        else if (frames_away_ != 0 && --frames_away_ == 0) {
            kernel_.bring_back(), lines.gone = false;
            if (one_of(2) == 0) ++counts_.power_lost, kernel_.plug_in();
        }
    }
    int lines_held() const {
        int held = 0;
        for (const FakeLine& line : fake.chips.at("gpiochip0").lines) held += line.used ? 1 : 0;
        return held;
    }

    std::mt19937 random_{20261126};
    KernelModel kernel_{*small_panel(), 256};
    Counts counts_{};
    int frames_away_ = 0;
};

TEST_F(Endurance, HundredThousandFrames) {
    constexpr int frames = 100'000;
    const host::Wires wires{.command = "GPIO25", .reset = "GPIO27", .backlight = "GPIO18", .devices = folder()};
    host::LastingScreen screen([&] { return host::wired_screen(wires, small_panel(), {}, kernel_); });
    Picture picture(1);
    for (int number = 0; number < frames; ++number) {
        pass_time();
        for (int rows = one_of(4); rows > 0; --rows) picture.change_row(one_of(small_height));
        if (screen.show(picture.image())) {
            ++counts_.shown;
            ASSERT_EQ(seen_on(kernel_.display()), picture.codes()) << "frame " << number << " is said to be shown";
            ASSERT_EQ(kernel_.display().complaint(), "") << "frame " << number;
            ASSERT_TRUE(kernel_.display().is_on() && line(18).value) << "frame " << number << " is dark";
        } else {
            ++counts_.lost;
            ASSERT_NE(screen.reason(), "");
        }
        ASSERT_EQ(lines_held(), screen.screen() ? 3 : 0) << "after frame " << number;
        ASSERT_EQ(kernel_.open_files, screen.screen() ? 1 : 0) << "after frame " << number;
    }
    EXPECT_EQ(counts_.shown + counts_.lost, frames);
    EXPECT_EQ(screen.figures().frames, static_cast<std::size_t>(counts_.shown));
    EXPECT_EQ(screen.lost(), static_cast<std::size_t>(counts_.lost));
    EXPECT_GT(counts_.device_gone, 100);
    EXPECT_GT(counts_.lines_gone, 100);
    screen.close();
    EXPECT_EQ(kernel_.open_files, 0);
    std::printf("%s\n", counts_.text().c_str());
    RecordProperty("counts", counts_.text());
}

}  // namespace
}  // namespace shade16::linux_spi
