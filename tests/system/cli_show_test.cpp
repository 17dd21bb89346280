// `shade16 show` as its users run it, where no panel hangs: what it would send, what it says is missing, and a terminal for a screen.
#include <display/all_panels.hpp>

#include <gmock/gmock.h>

#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include "tests/displays/model_bus.hpp"
#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

Ran show(const std::string& arguments) { return shade16_program("show " + arguments); }

void expect_refusal(const std::string& arguments, int exit_code, const std::string& sentence) {
    const Ran ran = show(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << arguments;
    EXPECT_EQ(ran.err, "shade16: " + sentence + "\n");
    EXPECT_THAT(ran.out, IsEmpty());
}

/// Sends a dry run's lines to a display; its pixels are white. The number of pixels of each transaction.
std::vector<int> send(const std::string& text, displays::DcsModel& display) {
    displays::ByteBus bus{&display};
    std::vector<int> counts;
    std::istringstream lines(text);
    for (std::string line, word; std::getline(lines, line);) {
        std::istringstream words(line);
        words >> word >> std::hex;
        if (word == "reset") bus.reset();
        else if (word == "command") {
            unsigned byte = 0;
            words >> byte;
            bus.command(static_cast<uint8_t>(byte));
            while (words >> byte) display.data(static_cast<uint8_t>(byte));
        } else {
            int number = 0;
            words >> std::dec >> number;
            if (word == "delay") bus.delay_ms(static_cast<uint32_t>(number));
            else if (word == "pixels") counts.push_back(number);
            else ADD_FAILURE() << "unknown line: " << line;
            if (word == "pixels") for (int i = 0; i < 2 * number; ++i) display.data(0xFF);
        }
    }
    return counts;
}

TEST(CliShow, a_dry_run_prints_what_every_panel_forgives) {
    for (const DcsPanel& panel : all_panels)
        for (const int turns : {0, 1, 2, 3}) {
            SCOPED_TRACE(std::string(panel.name) + " turned " + std::to_string(turns));
            const Ran ran = show(teapot() + " --dry-run --frames 2 --fps 1000 --panel " + panel.name + " --rotate " + std::to_string(90 * turns));
            ASSERT_EQ(ran.exit_code, 0) << ran.err;
            displays::DcsModel display(panel);
            const std::vector<int> counts = send(ran.out, display);
            display.end();
            EXPECT_EQ(display.complaint(), "");
            ASSERT_GE(counts.size(), 2u);
            EXPECT_EQ(counts[0], panel.width_px * panel.height_px);
            EXPECT_LT(std::accumulate(counts.begin() + 1, counts.end(), 0), counts[0]) << "rows that did not change were sent again";
            EXPECT_EQ(counts[1] % (turns % 2 == 0 ? panel.width_px : panel.height_px), 0) << "whole rows";
            EXPECT_THAT(ran.err, ContainsRegex("^shown: 2 frames in [0-9.]+ s, [0-9.]+ a second; [0-9]+ bytes a frame; sending took [0-9]+ % of the time\n$"));
        }
}

TEST(CliShow, a_panel_of_a_file_is_the_panel_of_its_name) {
    for (const DcsPanel& panel : all_panels) {
        const std::string dry = teapot() + " --dry-run --frames 1 --quiet --panel ", name = panel.name;
        const Ran file = show(dry + (source_directory() / "boards/panels" / (name + ".txt")).string());
        EXPECT_EQ(file.exit_code, 0) << file.err;
        EXPECT_EQ(file.out, show(dry + name).out) << name;
    }
}

/// Where a page shows `shade16 show`, with its scene and panel in place of the page's, and printed where it would need a device.
std::string runnable(const std::string& shown) {
    std::string command = std::regex_replace(shown, std::regex(R"(\S+\.(obj|toml))"), teapot());
    command = std::regex_replace(command, std::regex(R"(\S+\.txt)"), (source_directory() / "boards/panels/gc9a01.txt").string());
    if (command.find(teapot()) == std::string::npos) return command;
    if (command.find("--board fbdev") != std::string::npos) return command + " --frames 1 --framebuffer /dev/fb77";  // not on the screen of whoever tests
    return command + (command.find("--board") == std::string::npos ? " --frames 1 --dry-run" : " --frames 1");
}

TEST(CliShow, the_commands_of_the_pages_are_understood) {
    int commands = 0;
    for (const char* page : {"README.md", "docs/linux.md", "docs/panels.md"}) {
        std::ifstream lines(source_directory() / page);
        for (std::string line; std::getline(lines, line);) {
            const std::size_t at = line.find("shade16 show ");
            if (at == std::string::npos || !line.starts_with("    ")) continue;
            const std::string command = runnable(line.substr(at + 13, line.find("   ", at) - at - 13));
            const Ran ran = show(command);
            const bool misses_a_device = command.find("--probe") != std::string::npos || command.find("fbdev") != std::string::npos;
            EXPECT_TRUE(ran.exit_code == 0 || (misses_a_device && ran.exit_code != 2)) << page << ": " << line << "\n" << ran.err;
            ++commands;
        }
    }
    EXPECT_GT(commands, 10);
}

TEST(CliShow, lists_panels) {
    const Ran ran = show("--list-panels");
    EXPECT_EQ(ran.exit_code, 0);
    for (const DcsPanel& panel : all_panels)
        EXPECT_THAT(ran.out, ContainsRegex(std::string(panel.name) + " +" + std::to_string(panel.width_px) + "x" + std::to_string(panel.height_px) + "\n"));
}

TEST(CliShow, says_what_is_missing) {
    const std::string no_spi = "/dev/spidev77.1: there is no such device; expected one of /dev/spidev*.";
    const Ran probe = show("--probe --spi /dev/spidev77.1");
    EXPECT_EQ(probe.exit_code, 1);
    EXPECT_EQ(probe.out, "known    --panel ili9341\n"
                         "missing  --spi: " + no_spi + "\n"
                         "missing  --dc: the data/command line is not said; expected a line such as --dc GPIO25.\n");
    EXPECT_EQ(show("--probe --board fbdev --framebuffer /dev/fb77").out,
              "missing  --framebuffer: /dev/fb77: there is no such framebuffer; expected one of /dev/fb*.\n");
    expect_refusal(teapot(), 2, "the data/command line is not said; expected a line such as --dc GPIO25.");
    EXPECT_THAT(show(teapot() + " --dc gpiochip77:25").err, HasSubstr("line 'gpiochip77:25': there is no /dev/gpiochip77;"));
    EXPECT_EQ(show(teapot() + " --dc gpiochip77:25").exit_code, 2);
    expect_refusal(teapot() + " --board fbdev --framebuffer /dev/fb77", 3, "/dev/fb77: there is no such framebuffer; expected one of /dev/fb*.");
    const ScratchDirectory scratch;
    const std::string file = scratch.write("fb0", "not a device");
    expect_refusal(teapot() + " --board fbdev --framebuffer " + file, 3, file + ": is no framebuffer; expected one of /dev/fb*.");
}

TEST(CliShow, refuses_what_does_not_fit_together) {
    const std::string both = "; expected both, or neither.";
    expect_refusal(teapot() + " --board terminal --dc GPIO25", 2, "--dc: belongs to --board linux_spi" + both);
    expect_refusal(teapot() + " --framebuffer /dev/fb0", 2, "--framebuffer: belongs to --board fbdev" + both);
    expect_refusal(teapot() + " --data GPIO10", 2, "--data: belongs to --clock" + both);
    expect_refusal(teapot() + " --clock GPIO10", 2, "--clock: belongs to --data" + both);
    expect_refusal(teapot() + " --clock GPIO10 --data GPIO9 --spi-hz 1M", 2, "--spi-hz: --clock and --data take the place of SPI; expected the one or the other.");
    expect_refusal(teapot() + " --spi-hz 32mHz", 2, "--spi-hz 32mHz: expected a clock from 1k to 500M, such as 32M.");
    EXPECT_EQ(show("--list-panels --spi-hz 31.25MHz").exit_code, 0);
    expect_refusal(teapot() + " --spi-mode 1", 2, "--spi-mode 1: expected 0 or 3.");
    expect_refusal(teapot() + " --dc 25 --reset 25", 2, "--reset: is the line of --dc; expected another one.");
    expect_refusal(teapot() + " --rotate 45", 2, "--rotate 45: expected 0, 90, 180 or 270.");
    expect_refusal(teapot() + " --board spi", 2, "--board spi: expected linux_spi, fbdev or terminal.");
    expect_refusal(teapot() + " --panel st7788 --dry-run", 2, "panel 'st7788': there is none of this name; expected 'st7789', or another one of --list-panels.");
    expect_refusal(teapot() + " --panel no.txt --dry-run", 2, "no.txt: cannot be opened: No such file or directory.");
    expect_refusal("", 2, "the scene is missing: expected a scene file or a model; see 'shade16 show --help'.");
    expect_refusal("/no/such.obj --dry-run", 2, "/no/such.obj: cannot be opened: No such file or directory.");
}

TEST(CliShow, a_terminal_is_a_screen) {
    if (!has_program("script")) GTEST_SKIP() << "util-linux's script, which plays the terminal, is not installed.";
    const Ran ran = run_shell("export shade16 TERM=xterm; script -qefc 'stty cols 40 rows 12; $shade16 show --board terminal --frames 3 " + teapot() +
                              "' /dev/null </dev/null");
    EXPECT_THAT(ran.out, HasSubstr("\033[?25l"));
    EXPECT_THAT(ran.out, ContainsRegex("\033\\[\\?25h\r\nshown: 3 frames in [^\n]*\n$"));
    for (const char* command : {"preview ", "show --board terminal --fps 1000 "})  // q ends it where drawing leaves no time to wait, too
        EXPECT_EQ(run_shell("export shade16 TERM=xterm; (sleep 1; printf q) | timeout -k 1 20 script -qefc 'stty cols 300 rows 100; $shade16 " +
                            std::string(command) + teapot() + "' /dev/null").exit_code, 0) << command;
    EXPECT_EQ(show("--board terminal --quiet " + teapot()).out, shade16_program("preview " + teapot()).out) << "one frame where there is no terminal";
}

TEST(CliShow, figures_of_the_last_second_are_told_on_a_terminal) {
    if (!has_program("script")) GTEST_SKIP() << "util-linux's script, which plays the terminal, is not installed.";
    const std::string command = "$shade16 show --dry-run --panel st7735_80x160 --fps 50 --frames 75 " + teapot();
    const auto in_terminal = [](const std::string& line) {
        return run_shell("export shade16 TERM=xterm; script -qefc '" + line + " >/dev/null' /dev/null </dev/null").out;
    };
    EXPECT_THAT(in_terminal(command), ContainsRegex("\r\033\\[K[0-9.]+ frames a second, sending takes [0-9]+ % of the time\r\033\\[Kshown: 75 frames in "));
    EXPECT_EQ(in_terminal(command + " --quiet"), "");
}

TEST(CliShow, a_signal_ends_it_after_a_frame_with_the_status_that_a_shell_expects) {
    for (const auto& [name, number] : {std::pair{"INT", 2}, {"TERM", 15}, {"HUP", 1}}) {
        const Ran ran = run_shell("timeout --preserve-status -k 20 -s " + std::string(name) + " 0.5 \"$shade16\" show --dry-run --panel st7735_80x160 " + teapot());
        EXPECT_EQ(ran.exit_code, 128 + number) << name;
        EXPECT_THAT(ran.out, EndsWith("\n"));
        EXPECT_THAT(ran.err, StartsWith("shown: ")) << name;
    }
}

}  // namespace
}  // namespace shade16::host
