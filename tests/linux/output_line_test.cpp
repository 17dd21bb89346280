// Lines of libgpiod 1 and 2, over stubs of either: how they are found, what is said of each mistake, and that all is given back once.
#include "boards/linux_spi/output_line.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "boards/linux_spi/find_line.hpp"
#include "boards/linux_spi/permission.hpp"
#include "tests/linux/fake_chips.hpp"

namespace shade16::linux_spi {
namespace {

static_assert(std::is_nothrow_move_constructible_v<OutputLine> && !std::is_copy_constructible_v<OutputLine>);

class Lines : public FakeChips {
protected:
    LineOptions options() const { return {.devices = folder()}; }
    /// What is said of a line, with the devices' folder as /dev.
    std::string said_of(const std::string& wanted) const {
        std::string said = host::complaint([&] { OutputLine(wanted, options()); });
        for (std::size_t at; (at = said.find(folder())) != std::string::npos;) said.replace(at, folder().size(), "/dev");
        return said;
    }
    std::string place_of(const std::string& wanted) const {
        const Place place = find_line(wanted, folder());
        return place.chip.substr(folder().size() + 1) + ":" + std::to_string(place.offset);
    }
};

TEST_F(Lines, ByNameNumberOrChipAndOffset) {
    EXPECT_EQ(place_of("GPIO25"), "gpiochip0:25");
    EXPECT_EQ(place_of("25"), "gpiochip0:25");
    EXPECT_EQ(place_of("28"), "gpiochip0:28");  // no line has that name: the offset on the pin controller
    EXPECT_EQ(place_of("250"), "gpiochip10:1");
    EXPECT_EQ(place_of("gpiochip10:2"), "gpiochip10:2");
    EXPECT_EQ(place_of(device("gpiochip0") + ":3"), "gpiochip0:3");
}

TEST_F(Lines, AnotherNameOfAChipIsNoSecondChip) {
    std::filesystem::create_symlink("gpiochip0", device("gpiochip4"));
    EXPECT_EQ(place_of("GPIO25"), "gpiochip0:25");
}

TEST_F(Lines, AColonMayBePartOfAName) {
    fake.chips.at("gpiochip10").lines[1].name = "PHY:1";
    EXPECT_EQ(place_of("PHY:1"), "gpiochip10:1");
}

TEST_F(Lines, ChipsComeInTheOrderOfTheirNumbers) {
    add("gpiochip2", {});
    EXPECT_EQ(chips_of(folder()), (std::vector{device("gpiochip0"), device("gpiochip2"), device("gpiochip10")}));
}

TEST_F(Lines, AreHeldUnderANameUntilTheEnd) {
    {
        OutputLine first("GPIO25", {.active_low = true, .initially = true, .devices = folder()});
        EXPECT_TRUE(line(25).used && line(25).active_low && line(25).value);
        EXPECT_EQ(line(25).consumer, "shade16");
        first.set(false);
        EXPECT_FALSE(line(25).value);
        OutputLine second = std::move(first);
        second.set(true);
        EXPECT_TRUE(line(25).value);
        EXPECT_EQ(line(25).released, 0);
        second = OutputLine("GPIO24", options());
        EXPECT_EQ(line(25).released, 1);
        EXPECT_FALSE(line(24).active_low || line(24).value);
    }
    EXPECT_EQ(line(24).released, 1);
    EXPECT_EQ(line(25).released, 1);
}

TEST_F(Lines, AWrongNameHasItsNearest) {
    EXPECT_EQ(said_of("GPI25"), "2: no line of /dev/gpiochip0 and /dev/gpiochip10 is called 'GPI25'; did you mean GPIO25 or GPIO5?");
    EXPECT_EQ(said_of("GPIO28"), "2: no line of /dev/gpiochip0 and /dev/gpiochip10 is called 'GPIO28'; did you mean GPIO18, GPIO2 or GPIO20?");
    EXPECT_EQ(said_of("backlight"), "2: no line of /dev/gpiochip0 and /dev/gpiochip10 is called 'backlight'; expected a name such as GPIO0, or a chip and an "
                                    "offset, such as 'gpiochip0:25'.");
    EXPECT_EQ(said_of(""), "2: a line's name is empty; expected a name such as 'GPIO25', or a chip and an offset, such as 'gpiochip0:25'.");
}

TEST_F(Lines, WithoutNamesAChipAndAnOffsetAreAskedFor) {
    fake.chips.at("gpiochip0").lines = {{}, {}};
    fake.chips.at("gpiochip10").lines.clear();
    EXPECT_EQ(said_of("GPIO1"), "2: no line is called 'GPIO1', and no line of /dev/gpiochip0 and /dev/gpiochip10 has a name; expected a chip and an offset, such "
                                "as 'gpiochip0:25'.");
}

TEST_F(Lines, TwoAlikeAreToldApart) {
    EXPECT_EQ(said_of("TWIN"), "2: line 'TWIN' is on /dev/gpiochip10 (line 0) and /dev/gpiochip10 (line 2); say which, by 'gpiochip10:0' or 'gpiochip10:2'.");
    fake.chips.at("gpiochip10").label = "pinctrl-other";
    EXPECT_EQ(said_of("28"), "2: line '28' is on /dev/gpiochip0 (line 28) and /dev/gpiochip10 (line 28); say which, by 'gpiochip0:28' or 'gpiochip10:28'.");
}

TEST_F(Lines, WrongChipsAndOffsets) {
    EXPECT_EQ(said_of("gpiochip7:1"), "2: line 'gpiochip7:1': there is no /dev/gpiochip7; there is /dev/gpiochip0 and /dev/gpiochip10.");
    EXPECT_EQ(said_of("gpiochip10:3"), "2: line 'gpiochip10:3': /dev/gpiochip10 has no line 3; expected 0 to 2.");
    EXPECT_EQ(said_of("gpiochip0:x"), "2: line 'gpiochip0:x' has no number behind its colon; expected a chip and an offset, such as 'gpiochip0:25'.");
    EXPECT_EQ(said_of("gpiochip0:99999999999"), "2: line 'gpiochip0:99999999999' has no number behind its colon; expected a chip and an offset, such as 'gpiochip0:25'.");
    EXPECT_EQ(said_of("99"), "2: line '99': /dev/gpiochip0 has no line 99; expected 0 to 28.");
    fake.chips.at("gpiochip0").label = "gpio-sim";
    EXPECT_EQ(said_of("99"), "2: line '99': no line is called 'GPIO99', and no chip's label begins with 'pinctrl-'; expected a chip, too, such as 'gpiochip0:99'.");
    fake.chips.at("gpiochip0").open_error = ENOTTY;
    EXPECT_EQ(said_of("gpiochip0:1"), "3: line 'gpiochip0:1': /dev/gpiochip0 cannot be opened: Inappropriate ioctl for device; expected a chip with lines.");
}

TEST_F(Lines, NoChipsAtAll) {
    std::filesystem::remove(device("gpiochip0")), std::filesystem::remove(device("gpiochip10"));
    EXPECT_EQ(said_of("GPIO1"), "3: line 'GPIO1': there is no /dev/gpiochip0, nor any other chip with lines; expected a kernel with a driver for the board's GPIO.");
    fake.chips.clear();
    EXPECT_EQ(said_of("gpiochip0:1"), "2: line 'gpiochip0:1': there is no /dev/gpiochip0; this computer has no chip with lines.");
}

TEST_F(Lines, ABusyLineHasAHolder) {
    const OutputLine held("GPIO25", {.consumer = "somebody else", .devices = folder()});
    EXPECT_EQ(said_of("GPIO25"), "3: line 'GPIO25' (/dev/gpiochip0, line 25) is busy: 'somebody else' holds it; end that, or choose another line.");
    line(25).consumer = "";
    EXPECT_EQ(said_of("25"), "3: line '25' (/dev/gpiochip0, line 25) is busy: another program holds it; end that, or choose another line.");
    EXPECT_TRUE(line(25).used);
}

TEST_F(Lines, ARefusalNamesTheGroup) {
    fake.chips.at("gpiochip0").open_error = EACCES;
    const std::string groups = devices_.write("group", "root:x:0:\nbroken\ngpio:x:997:pi\n");
    const auto said = [&](unsigned group, unsigned mode) {
        EXPECT_EQ(chown(device("gpiochip0").c_str(), static_cast<uid_t>(-1), group), 0);
        std::filesystem::permissions(device("gpiochip0"), static_cast<std::filesystem::perms>(mode));
        std::string text = permission_denied("line 'GPIO25'", device("gpiochip0"), "gpio", groups).what();
        for (std::size_t at; (at = text.find(folder())) != std::string::npos;) text.replace(at, folder().size(), "/dev");
        return text;
    };
    const std::string alone = "line 'GPIO25': /dev/gpiochip0 is open to root alone; 'sudo chgrp gpio /dev/gpiochip0' and 'sudo chmod g+rw /dev/gpiochip0' (or a "
                              "udev rule that does so at every start), 'sudo adduser $USER gpio' and a new login mend it.";
    if (geteuid() == 0) {  // only root gives a file to any group
        EXPECT_EQ(said(997, 0660), "line 'GPIO25': /dev/gpiochip0 is open to group 'gpio' alone, and this user is not in it; 'sudo adduser $USER gpio' and a new "
                                   "login mend it.");
        EXPECT_EQ(said(0, 0660), alone);
    }
    EXPECT_EQ(said(getegid(), 0600), alone);
    EXPECT_EQ(said_of("GPIO25"), "3: " + alone);
    EXPECT_EQ(said_of("25"), "3: line '25" + alone.substr(12));
    EXPECT_EQ(said_of("gpiochip0:25"), "3: line 'gpiochip0:25" + alone.substr(12));
    fake.chips.at("gpiochip0").open_error = 0, fake.chips.at("gpiochip0").request_error = EPERM;
    EXPECT_EQ(said_of("GPIO25"), "3: " + alone);
}

TEST_F(Lines, AChipOfAnotherUsersHidesNoLineOfThisOnes) {
    fake.chips.at("gpiochip10").open_error = EACCES;
    EXPECT_EQ(place_of("GPIO25"), "gpiochip0:25");
}

TEST_F(Lines, AChipThatGoesSaysSo) {
    OutputLine held("GPIO25", options());
    fake.chips.at("gpiochip0").gone = true;
    EXPECT_EQ(said_of("GPIO24"), "3: line 'GPIO24': its chip /dev/gpiochip0 is gone; expected it to stay plugged in while the display is driven.");
    const std::string said = host::complaint([&] { held.set(true); });
    EXPECT_EQ(said, "3: line 'GPIO25': its chip " + device("gpiochip0") + " is gone; expected it to stay plugged in while the display is driven.");
}

TEST_F(Lines, OtherErrorsAreTheKernelsWords) {
    OutputLine held("GPIO25", options());
    fake.step = 0, fake.fail_at = 1, fake.fail_with = EIO;
    EXPECT_EQ(host::complaint([&] { held.set(true); }), "3: line 'GPIO25' (" + device("gpiochip0") + ") cannot be set: Input/output error; expected an output.");
    fake.chips.at("gpiochip0").request_error = ENXIO;
    EXPECT_EQ(said_of("GPIO24"), "3: line 'GPIO24' (/dev/gpiochip0, line 24) cannot be an output: No such device or address; expected a line that can.");
}

/// Whichever call fails, all is given back (FakeChips looks), and the failure is a sentence or, on a chip looked through, passed over.
TEST_F(Lines, EveryCallMayFail) {
    for (const int error : {ENOMEM, EACCES, ENODEV, EBUSY, EIO}) {
        int failures = 0;
        for (fake.fail_at = 1, fake.fail_with = error;; ++fake.fail_at) {
            fake.step = 0;
            const std::string said = host::complaint([&] { OutputLine("GPIO25", options()).set(true); });
            if (said != "no complaint") ++failures;
            EXPECT_EQ(fake.things, 0) << "call " << fake.fail_at << ", error " << error;
            EXPECT_EQ(line(25).requested, line(25).released) << "call " << fake.fail_at << ", error " << error;
            if (fake.step < fake.fail_at) break;  // none was left to fail
        }
        EXPECT_GT(failures, 4) << error;
        fake.fail_at = 0;
    }
}

}  // namespace
}  // namespace shade16::linux_spi
