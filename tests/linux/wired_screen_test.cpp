// A panel at this computer's lines: the picture that arrives, what the lines say before and after, and what is missing.
#include "host_sim/screen/wired_screen.hpp"

#include <gtest/gtest.h>

#include "boards/linux_spi/device_gone.hpp"
#include "tests/linux/fake_chips.hpp"
#include "tests/linux/kernel_model.hpp"
#include "tests/linux/small_panel.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::linux_spi {
namespace {

class WiredScreen : public FakeChips {
protected:
    std::unique_ptr<host::Screen> open() { return host::wired_screen(wires_, small_panel(), {}, kernel_); }
    bool is_lit() { return line(18).value; }

    KernelModel kernel_{*small_panel(), 256};
    host::Wires wires_{.command = "GPIO25", .reset = "GPIO27", .backlight = "GPIO18", .devices = folder()};
};

TEST_F(WiredScreen, ShowsFramesAndSendsOnlyRowsThatChanged) {
    const auto screen = open();
    EXPECT_FALSE(is_lit()) << "nothing is there to see";
    Picture picture(3);
    screen->show(picture.image());
    EXPECT_EQ(seen_on(kernel_.display()), picture.codes());
    EXPECT_TRUE(is_lit());
    EXPECT_EQ(screen->figures().bytes, picture.image().raw.size());

    picture.change_row(5), picture.change_row(6), picture.change_row(11);
    screen->show(picture.image());
    EXPECT_EQ(seen_on(kernel_.display()), picture.codes());
    EXPECT_EQ(screen->figures().bytes, picture.image().raw.size() + 3 * 2 * small_width);
    kernel_.display().end();
    EXPECT_EQ(kernel_.display().complaint(), "");
}

TEST_F(WiredScreen, EndsDarkWhenAsked) {
    for (const bool dark : {false, true}) {
        wires_.is_dark_at_end = dark;
        auto screen = open();
        screen->show(Picture(3).image());
        if (dark) screen->switch_off();
        screen.reset();
        EXPECT_EQ(is_lit(), !dark);
        EXPECT_EQ(kernel_.display().is_on(), !dark);
        EXPECT_EQ(kernel_.open_files, 0);
        kernel_.plug_in();
    }
}

TEST_F(WiredScreen, ADeviceThatGoesInMidFrameIsSaidToHaveGone) {
    wires_.is_dark_at_end = true;
    auto screen = open();
    int messages = 0;
    kernel_.fate = [&](std::size_t bytes) { return ++messages == 6 ? -ENODEV : static_cast<int>(bytes); };
    EXPECT_THROW(screen->show(Picture(3).image()), DeviceGone);
    screen.reset();
    kernel_.fate = [](std::size_t bytes) { return static_cast<int>(bytes); };
    screen = open();
    fake.chips.at("gpiochip0").gone = true;
    EXPECT_THROW(screen->show(Picture(3).image()), DeviceGone);
}

TEST_F(WiredScreen, NoticesThatTheDeviceHasGoneUnderAStillPicture) {
    const auto screen = open();
    const Picture picture(3);
    screen->show(picture.image());
    screen->show(picture.image());
    EXPECT_EQ(screen->figures().bytes, picture.image().raw.size());
    EXPECT_EQ(kernel_.display().complaint(), "");
    kernel_.take_away(), kernel_.bring_back();
    EXPECT_THROW(screen->show(picture.image()), DeviceGone);
}

TEST_F(WiredScreen, SendsBitByBitWhereThereIsNoSpi) {
    kernel_.open_error = ENOENT;
    wires_.clock = "GPIO11", wires_.data = "GPIO10", wires_.select = "GPIO8";
    int byte = 0, bits = 0;
    fake.changed = [&](const FakeLine& line) {
        if (line.name == "GPIO27") kernel_.display().reset_line(line.value), bits = 0;
        if (line.name != "GPIO11" || !line.value || this->line(8).value) return;
        byte = byte << 1 | (this->line(10).value ? 1 : 0);
        if (++bits % 8 == 0) kernel_.take(static_cast<uint8_t>(byte));
    };
    const Picture picture(3);
    open()->show(picture.image());
    EXPECT_EQ(seen_on(kernel_.display()), picture.codes());
    EXPECT_EQ(kernel_.display().complaint(), "");
}

TEST_F(WiredScreen, SaysWhatIsMissingAndHoldsNothingThen) {
    const auto sentence = [&] { return host::complaint([&] { open(); }); };
    wires_.command = "";
    EXPECT_EQ(sentence().substr(0, 26), "2: a line's name is empty;");
    wires_.command = "GPIO25", wires_.reset = "GPIO77";
    EXPECT_EQ(sentence().substr(0, 11), "2: no line ");
    wires_.reset = "GPIO27", kernel_.open_error = EBUSY;
    EXPECT_EQ(sentence(), "3: /dev/spidev0.0: cannot be opened: Device or resource busy.");
}

}  // namespace
}  // namespace shade16::linux_spi
