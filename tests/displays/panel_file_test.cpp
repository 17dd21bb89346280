// Panels as text: what their lines mean, that each text is the driver of its name, and the sentence for each mistake.
#include "host_sim/screen/panel_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include <display/all_panels.hpp>
#include "tests/system/scratch_directory.hpp"

namespace shade16::displays {
namespace {

using host::PanelFile;
using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path folder = host::source_directory() / "boards/panels";

std::map<std::string, DcsPanel> compiled_panels() {
    std::map<std::string, DcsPanel> panels;
    for (const DcsPanel& panel : all_panels) panels.emplace(panel.name, panel);
    return panels;
}

/// A text on its own; or on this one, as `base`.
PanelFile read(const std::string& text, const std::string& base = "") {
    return host::read_panel_text(text, "glass/mine.txt", [&base](const std::string& path) {
        EXPECT_EQ(path, "glass/base.txt");
        return base;
    });
}

const std::string rest = "command 0x11\ndelay 120\ncommand 0x36 0xC0\n#: glass 10 20\n";

/// All but the name and the list.
std::vector<int> facts(const DcsPanel& p) {
    return {p.width_px,  p.height_px,        p.memory_width_px, p.memory_height_px, p.first_column,
            p.first_row, p.columns_mirrored, p.rows_mirrored,   p.blue_first,       p.inverted};
}

TEST(PanelFile, EveryTextIsTheDriverOfItsName) {
    std::map<std::string, DcsPanel> compiled = compiled_panels();
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const PanelFile file = host::read_panel_file(entry.path().string());
        const DcsPanel text = file.panel();
        ASSERT_EQ(compiled.count(text.name), 1u) << entry.path() << " has no driver in firmware/display/all_panels.hpp; add it there";
        const DcsPanel driver = compiled.extract(text.name).mapped();
        EXPECT_EQ(std::vector(driver.beginning, driver.beginning + driver.beginning_bytes), file.beginning) << text.name;
        EXPECT_EQ(facts(driver), facts(text)) << text.name;
    }
    for (const auto& [name, panel] : compiled) ADD_FAILURE() << name << " has no text in boards/panels";
}

TEST(PanelFile, TheViewOutlivesACopyOfTheFile) {
    const PanelFile second = [] { return PanelFile(host::read_panel_file((folder / "st7735_80x160_plug_in.txt").string())); }();
    EXPECT_STREQ(second.panel().name, "st7735_80x160_plug_in");
    EXPECT_EQ(second.panel().beginning, second.beginning.data());
}

TEST(PanelFile, NumbersAreDecimalOrHexadecimal) {
    EXPECT_THAT(read("command 0xb1 0 0X18 255 # a comment\r\n" + rest).beginning, ElementsAre(0xB1, 3, 0, 0x18, 255, 0x11, then_wait, 24));
}

TEST(PanelFile, WaitsAddUpInStepsOfFiveMilliseconds) {
    EXPECT_THAT(read("command 1\ndelay 0\n" + rest).beginning, ElementsAre(1, 0, 0x11, then_wait, 24));
    EXPECT_THAT(read("command 1\ndelay 1\n" + rest).beginning, ElementsAre(1, then_wait, 1, 0x11, then_wait, 24));
    EXPECT_THAT(read("command 1 7\ndelay 3\ndelay 3\n" + rest).beginning, ElementsAre(1, then_wait | 1, 7, 2, 0x11, then_wait, 24));
    EXPECT_THAT(read("delay 10\n" + rest).beginning, ElementsAre(0, then_wait, 2, 0x11, then_wait, 24));
    EXPECT_THAT(read("command 1\ncommand 0 10\n" + rest).beginning, ElementsAre(1, then_wait, 2, 0x11, then_wait, 24));
}

TEST(PanelFile, LongWaitsAreSplit) {
    const auto after = [](int waits) {
        std::string text = "command 1\n";
        for (int i = 0; i < waits; ++i) text += "delay 255\n";
        return read(text + rest).beginning;
    };
    EXPECT_THAT(after(5), ElementsAre(1, then_wait, 255, 0x11, then_wait, 24));
    EXPECT_THAT(after(6), ElementsAre(1, then_wait, 255, 0, then_wait, 51, 0x11, then_wait, 24));
    EXPECT_THAT(after(11), ElementsAre(1, then_wait, 255, 0, then_wait, 255, 0, then_wait, 51, 0x11, then_wait, 24));
}

TEST(PanelFile, WhatDriversSendThemselvesIsNoPartOfTheList) {
    const PanelFile file = read("command 0x3A 0x05\ncommand 0x21\ncommand 0x13\ncommand 0x29\ndelay 20\n" + rest);
    EXPECT_THAT(file.beginning, ElementsAre(0, then_wait, 4, 0x11, then_wait, 24));
    EXPECT_TRUE(file.facts.inverted);
}

TEST(PanelFile, WhatComesLaterHolds) {
    const PanelFile file = read("#: as base\ncommand 0x36 0x08\ncommand 0x20\n#: memory 12 24 \n#: offset 1 3\n", "command 0x21\n" + rest);
    EXPECT_FALSE(file.facts.inverted || file.facts.columns_mirrored || file.facts.rows_mirrored);
    EXPECT_TRUE(file.facts.blue_first);
    EXPECT_EQ(file.facts.width_px, 10);
    EXPECT_EQ(file.facts.memory_height_px, 24);
    EXPECT_EQ(file.facts.first_column, 1);
    EXPECT_EQ(file.facts.first_row, 3);
}

TEST(PanelFile, TheOffsetIsTheUprightPicturesOnThatWire) {
    for (const auto& [name, x, y] : {std::tuple{"st7789_135x240", 53, 40}, {"st7789_240x240", 0, 80}, {"st7735_128x128", 2, 3}, {"gc9a01", 0, 0}}) {
        const PanelFile file = host::read_panel_file((folder / (std::string(name) + ".txt")).string());
        const dcs::Gap gap = dcs::gap_of(file.panel(), {});
        EXPECT_EQ(gap.x, x) << name;
        EXPECT_EQ(gap.y, y) << name;
    }
}

std::string refusal(const std::string& text, const std::string& base = "") {
    return host::complaint([&] { read(text, base); });
}

TEST(PanelFile, EveryMistakeHasItsSentence) {
    const std::string many = [] {
        std::string line = "command 0x2D";
        for (int i = 0; i < 128; ++i) line += " 0";
        return line + "\n";
    }();
    const std::pair<std::string, std::string> mistakes[] = {
        {"comand 0x11\n", "2: glass/mine.txt, line 1: unknown word 'comand'; expected 'command'."},
        {"\n\nfoo 1\n", "line 3: unknown word 'foo'; expected 'command', 'delay'."},
        {"#: glas 1 2\n", "line 1: unknown word 'glas'; expected 'glass'."},
        {"glass 1 2\n", "line 1: unknown word 'glass'"},
        {"command 0x100\n", "'0x100' of 'command' is out of range; expected 0 to 255."},
        {"command 99999999999999999999\n", "is out of range; expected 0 to 255."},
        {"command -1\n", "'-1' of 'command' is not a number; expected one such as 120 or 0x78."},
        {"command 017\n", "'017' of 'command' is not a number"},
        {"command 0x\n", "'0x' of 'command' is not a number"},
        {"command\n", "'command' has 0 numbers; expected 1, as in 'command 0xB1 0x00 0x18'."},
        {many, "a command has 128 parameters; expected at most 127."},
        {"delay soon\n", "'soon' of 'delay' is not a number"},
        {"delay 500\n", "'500' of 'delay' is out of range; expected 0 to 255. Write a longer delay as several lines."},
        {"delay 1 2\n", "'delay' has 2 numbers; expected 1, as in 'delay 120'."},
        {"command 0x36\n", "command 0x36 has 0 parameters; expected 1."},
        {"command 0x21 0\n", "command 0x21 has 1 parameters; expected 0."},
        {"command 0x3A 0x66\n", "the pixel format is 0x66; expected 0x55 or 0x05, 16 bits a pixel."},
        {"command 0x36 0xA0\n", "command 0x36 0xA0 turns the picture; expected what an upright one takes, 0xC0 or 0x00."},
        {"command 0x36 0x54\n", "command 0x36 0x54 sets the bits 0x14, which no driver here does; expected 0x80, 0x40 and 0x08 at most."},
        {"#: glass 240\n", "'glass' has 1 numbers; expected 2, as in '#: glass 240 320'."},
        {"#: glass 2049 1\n", "'2049' of 'glass' is out of range; expected 0 to 2048."},
        {"#: as ../secrets\n", "'as' takes the name of a panel in the same folder; expected one such as '#: as st7789'."},
        {rest + "#: as base\n", "line 5: 'as' comes after other lines; expected it before them, once."},
        {"", "2: glass/mine.txt: does not say how large the glass is; expected a line such as '#: glass 240 320'."},
        {"#: glass 1 1\ncommand 0x11\n", "glass/mine.txt: does not say how the glass is wired; expected a line such as 'command 0x36 0x00'."},
        {"#: glass 1 1\ncommand 0x36 0\n", "glass/mine.txt: never wakes the panel; expected 'command 0x11' and 'delay 120'."},
        {rest + "#: glass 0 1\n", "line 5: the glass has no pixel; expected at least 1 by 1."},
        {rest + "#: memory 10 19\n", "line 4: the glass of 10x20 at 0, 0 is larger than the memory of 10x19; expected '#: memory' of at least 10 20."},
        {rest + "#: offset 1 0\n", "the glass of 10x20 at 1, 0 is larger than the memory of 10x20"},
    };
    for (const auto& [text, sentence] : mistakes) EXPECT_THAT(refusal(text), HasSubstr(sentence)) << text;
    EXPECT_THAT(refusal("#: as base\n" + rest, "#: as other\n" + rest),
                HasSubstr("glass/base.txt, line 1: stands on another panel, and glass/mine.txt, line 1 stands on this one; expected '#: as other' there."));
    EXPECT_THAT(refusal("#: as base\n", "delay x\n"), HasSubstr("glass/base.txt, line 1: 'x'"));
    EXPECT_EQ(refusal(rest), "no complaint");
}

/// The page's indented text from this line on.
std::string example(const std::string& page, const std::string& first_line) {
    std::string text;
    std::istringstream lines(page.substr(std::min(page.find("    " + first_line), page.size())));
    for (std::string line; std::getline(lines, line) && (line.empty() || line.starts_with("    "));)
        text += line.substr(std::min<std::size_t>(4, line.size())) + "\n";
    return text;
}

TEST(PanelFile, ThePagesExamplesAreRead) {
    std::ifstream file(SHADE16_DOCS "/panels.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const PanelFile whole = read(example(page, "# ST7789V, the smallest"));
    EXPECT_THAT(whole.beginning, ElementsAre(dcs::reset, then_wait, 30, dcs::sleep_out, then_wait, 24));
    EXPECT_EQ(facts(whole.facts), facts(st7789));

    const PanelFile narrow = host::read_panel_text(example(page, "#: as st7789"), (folder / "mine.txt").string(), [](const std::string& path) {
        std::ifstream base(path);
        return std::string{std::istreambuf_iterator<char>(base), {}};
    });
    EXPECT_EQ(narrow.facts.width_px, 170);
    EXPECT_EQ(narrow.facts.first_column, 35);
    EXPECT_EQ(narrow.beginning, std::vector(st7789.beginning, st7789.beginning + st7789.beginning_bytes));
}

TEST(PanelFile, APanelThatItStandsOnIsLookedForBesideIt) {
    const host::ScratchDirectory scratch;
    const std::string mine = scratch.write("mine.txt", "# mine\n#: as st7789\n#: glass 1 1\n");
    EXPECT_EQ(host::complaint([&] { host::read_panel_file(mine); }),
              "2: " + mine + ", line 2: stands on 'st7789', which is looked for in the same folder: " + scratch.path("st7789.txt") +
                  ": cannot be opened: No such file or directory.");
}

TEST(PanelFile, AFileThatIsMissingIsNamed) {
    const host::ScratchDirectory scratch;
    EXPECT_THAT(host::complaint([&] { host::read_panel_file(scratch.path("none.txt")); }), HasSubstr("none.txt: cannot be opened"));
    const std::string mine = scratch.write("mine.txt", "#: as none\n");
    EXPECT_THAT(host::complaint([&] { host::read_panel_file(mine); }), HasSubstr("none.txt: cannot be opened"));
}

}  // namespace
}  // namespace shade16::displays
