// The texts of boards/panels as Linux's driver panel-mipi-dbi takes them, by a reading of its own: compiled to its firmware, sent, and
// a picture after them. Our directives are comments to it; a glass that stands on another panel comes after that one's text.
// Source: the tool mipi-dbi-cmd of notro/panel-mipi-dbi (the syntax), Linux's drivers/gpu/drm/tiny/panel-mipi-dbi.c (the firmware).
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include <display/all_panels.hpp>
#include "tests/displays/model_bus.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::displays {
namespace {

using Bytes = std::vector<uint8_t>;
const Bytes header{'M', 'I', 'P', 'I', ' ', 'D', 'B', 'I', 0, 0, 0, 0, 0, 0, 0, 1};  // and the version

Bytes byte_values(std::istringstream& words) {
    Bytes bytes;
    for (std::string word; words >> word;) {
        std::size_t used = 0;
        const int value = std::stoi(word, &used, 0);
        const bool octal = word.size() > 1 && word[0] == '0' && word[1] != 'x';  // Python, which the tool is written in, has none
        if (octal || used != word.size() || value < 0 || value > 255) throw std::invalid_argument("no byte: " + word);
        bytes.push_back(static_cast<uint8_t>(value));
    }
    return bytes;
}

/// What mipi-dbi-cmd writes for a text; throws what it refuses.
Bytes firmware_of(const std::string& text) {
    Bytes firmware = header;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string word;
        if (!(words >> word)) continue;
        Bytes bytes = byte_values(words);
        if (word == "delay" && bytes.size() == 1) bytes = {0x00, bytes[0]};
        else if (word != "command" || bytes.empty()) throw std::invalid_argument("no command: " + line);
        bytes.insert(bytes.begin() + 1, static_cast<uint8_t>(bytes.size() - 1));
        firmware.insert(firmware.end(), bytes.begin(), bytes.end());
    }
    return firmware;
}

/// As the driver does when the display is switched on.
void send_firmware(ByteBus& bus, const Bytes& firmware) {
    ASSERT_TRUE(std::equal(header.begin(), header.end(), firmware.begin()));
    bus.reset();
    bus.command(dcs::reset);
    bus.delay_ms(5);
    for (std::size_t at = header.size(); at < firmware.size();) {
        const uint8_t command = firmware[at];
        ASSERT_LT(at + 1, firmware.size());
        const std::size_t count = firmware[at + 1];
        ASSERT_LE(at + 2 + count, firmware.size());
        if (command == 0x00 && count == 1) {
            bus.delay_ms(firmware[at + 2]);
        } else {
            bus.command(command);
            if (count != 0) bus.data(&firmware[at + 2], count);
        }
        at += 2 + count;
    }
}

std::string text_of(const std::string& panel) {
    std::ifstream file(host::source_directory() / "boards/panels" / (panel + ".txt"), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t as = text.find("#: as ");
    if (as == text.npos) return text;
    return text_of(text.substr(as + 6, text.find('\n', as) - as - 6)) + text;
}

/// The last of a directive's: what goes into the device tree.
std::pair<int, int> device_tree(const std::string& text, const std::string& directive, std::pair<int, int> otherwise) {
    const std::size_t at = text.rfind("#: " + directive + " ");
    if (at == text.npos) return otherwise;
    std::istringstream numbers(text.substr(at + 4 + directive.size()));
    numbers >> otherwise.first >> otherwise.second;
    return otherwise;
}

/// One frame, as the driver sends it: all of the glass.
void send_picture(ByteBus& bus, const Seen& picture, std::pair<int, int> offset) {
    const auto window = [&bus](uint8_t command, int first, int count) {
        const int last = first + count - 1;
        const uint8_t bytes[] = {static_cast<uint8_t>(first >> 8), static_cast<uint8_t>(first), static_cast<uint8_t>(last >> 8),
                                 static_cast<uint8_t>(last)};
        bus.command(command), bus.data(bytes, 4);
    };
    window(dcs::columns, offset.first, picture.width);
    window(dcs::rows, offset.second, picture.height);
    bus.command(dcs::write_memory);
    for (const uint16_t pixel : picture.pixels) {
        const uint8_t bytes[] = {static_cast<uint8_t>(pixel >> 8), static_cast<uint8_t>(pixel)};
        bus.data(bytes, 2);
    }
}

TEST(PanelsForTheKernel, EveryTextShowsAnUprightPicture) {
    for (const DcsPanel& panel : all_panels) {
        const std::string text = text_of(panel.name);
        const auto [width, height] = device_tree(text, "glass", {0, 0});
        Seen picture{width, height, {}};
        std::mt19937 engine(11);
        for (int i = 0; i < width * height; ++i) picture.pixels.push_back(static_cast<uint16_t>(engine()));

        DcsModel model(panel);
        ByteBus bus;
        bus.model = &model;
        send_firmware(bus, firmware_of(text));
        send_picture(bus, picture, device_tree(text, "offset", {0, 0}));
        model.end();
        EXPECT_EQ(model.complaint(), "") << panel.name;
        EXPECT_TRUE(model.seen() == picture) << panel.name;
    }
}

TEST(PanelsForTheKernel, TheFirmwareIsAsTheDriverDocumentsIt) {
    Bytes expected = header;
    const Bytes commands{0x11, 0, 0x00, 1, 120, 0xB1, 3, 0x01, 0x2C, 0x2D, 0x29, 0};
    expected.insert(expected.end(), commands.begin(), commands.end());
    EXPECT_EQ(firmware_of("command 0x11 # sleep out\ndelay 120\n\n#: glass 1 1\ncommand 0xb1 0x01 0x2C 45\ncommand 0x29"), expected);
}

TEST(PanelsForTheKernel, WhatItsToolRefusesIsRefused) {
    for (const char* line : {"delay 500", "delay 1 2", "delay", "command", "command 256", "command 0x36 -1", "command 0x1Z",
                             "command 017", "glass 1 2", "sleep 5"})
        EXPECT_THROW(firmware_of(line), std::logic_error) << line;
}

}  // namespace
}  // namespace shade16::displays
