// The OLED controllers with commands of their own, each against a small strict model.
#include <gtest/gtest.h>

#include <display/ssd1306.hpp>
#include <display/ssd1351.hpp>
#include <random>
#include <string>
#include <vector>

namespace shade16::displays {
namespace {

/// Takes an SSD1306's bytes. Source: its data sheet, 9: what each command is followed by.
struct Ssd1306Model {
    std::string complaint{};
    int first_column = 0, last_column = 127, first_page = 0, last_page = 7, column = 0, page = 0, mode = 2;
    bool on = false, charged = false;
    std::vector<uint8_t> command{};
    uint8_t memory[8][128]{};

    void complain(const char* sentence) {
        if (complaint.empty()) complaint = sentence;
    }
    static size_t length(uint8_t c) {
        switch (c) {
            case 0x21:
            case 0x22: return 3;
            case 0x20: case 0x81: case 0x8D: case 0xA8: case 0xD3: case 0xD5: case 0xD9: case 0xDA: case 0xDB: return 2;
            default: return 1;
        }
    }
    void take(uint8_t control, uint8_t byte) {
        if (control == 0x40) return data(byte);
        if (control != 0x80) return complain("a control byte is neither of a command nor of data");
        command.push_back(byte);
        if (command.size() < length(command[0])) return;
        if (command[0] == 0x20) mode = command[1];
        if (command[0] == 0x8D) charged = (command[1] & 4) != 0;
        if (command[0] == 0x21) first_column = column = command[1], last_column = command[2];
        if (command[0] == 0x22) first_page = page = command[1], last_page = command[2];
        if (command[0] == 0xAF) on = true;
        if (last_column > 127 || first_column > last_column || last_page > 7 || first_page > last_page) complain("the window is not in the memory");
        command.clear();
    }
    void data(uint8_t byte) {
        if (!command.empty()) return complain("data came in the middle of a command");
        if (mode != 0) return complain("data came, and columns do not run first");
        if (!on || !charged) return complain("the display is off, or has no voltage");
        memory[page][column] = byte;
        if (column++ < last_column) return;
        column = first_column;
        page = page < last_page ? page + 1 : first_page;
    }
};

Ssd1306Model* wired = nullptr;
struct ModelI2c {
    static void begin() {}
    static void send(uint8_t device, uint8_t control, uint8_t byte) {
        if (device != 0x3C) wired->complain("another device was called");
        wired->take(control, byte);
    }
};

TEST(Ssd1306, ShowsThePictureInPages) {
    Ssd1306Model model;
    wired = &model;
    Ssd1306<ModelI2c> display;
    BandBuffer<Mono1, 128, 64, false> picture;
    std::mt19937 engine(3);
    for (uint8_t& byte : picture.pixels) byte = static_cast<uint8_t>(engine());
    for (int y = 0; y < 64; y += 16) display.flush({0, y, 128, 16}, picture.pixels + 16 * y, 256, y == 48);
    EXPECT_EQ(model.complaint, "");
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x)
            ASSERT_EQ(model.memory[y / 8][x] >> (y % 8) & 1, static_cast<int>(luma_code<Mono1>(picture.band().row(y), x))) << x << ", " << y;
}

/// Takes an SSD1351's bytes. Source: its data sheet, 8.1 and 9: a window is two bytes, and what is written goes on in it.
struct Ssd1351Model {
    std::string complaint{};
    uint8_t command_ = 0, remap = 0, locked = 1;
    bool on = false, was_reset = false;
    std::vector<uint8_t> parameters{};
    int first_column = 0, last_column = 127, first_row = 0, last_row = 127, column = 0, row = 0;
    std::vector<uint16_t> memory = std::vector<uint16_t>(128 * 128);

    void complain(const char* sentence) {
        if (complaint.empty()) complaint = sentence;
    }
    void command(uint8_t byte) {
        if (!was_reset) complain("a command came before the display was reset");
        if (byte != 0xFD && locked != 0) complain("a command came while the display was locked");
        command_ = byte, parameters.clear();
        if (byte == 0xAF) on = true;
    }
    void data(uint8_t byte) {
        parameters.push_back(byte);
        if (command_ == 0xFD && byte == 0xB1) locked = 0;
        if (command_ == 0xA0) remap = byte;
        if (parameters.size() < 2) return;
        if (command_ == 0x15) first_column = column = parameters[0], last_column = parameters[1];
        if (command_ == 0x75) first_row = row = parameters[0], last_row = parameters[1];
        if (last_column > 127 || last_row > 127 || first_column > last_column || first_row > last_row) complain("the window is not in the memory");
        if (command_ != 0x5C) return;
        if ((remap & 0xC0) != 0x40) complain("pixels came, and colours are not of 16 bits");
        if (!on) complain("pixels came while the display was off");
        memory[static_cast<size_t>(row * 128 + column)] = static_cast<uint16_t>(parameters[0] << 8 | parameters[1]);
        parameters.clear();
        if (column++ < last_column) return;
        column = first_column, row = row < last_row ? row + 1 : first_row;
    }
};

struct ModelSpi {
    using Format = Rgb565Swapped;
    Ssd1351Model* model = nullptr;
    void reset() { model->was_reset = true; }
    void command(uint8_t byte) { model->command(byte); }
    void data(const uint8_t* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i) model->data(bytes[i]);
    }
    void pixels(const uint16_t* pixels, size_t count) { data(reinterpret_cast<const uint8_t*>(pixels), 2 * count); }
    void wait() {}
    void delay_ms(uint32_t) {}
};

TEST(Ssd1351, ShowsThePicture) {
    Ssd1351Model model;
    Ssd1351<ModelSpi> display(ModelSpi{&model});
    std::mt19937 engine(4);
    std::vector<uint16_t> codes(128 * 128), sent;
    for (uint16_t& code : codes) code = static_cast<uint16_t>(engine()), sent.push_back(Rgb565Swapped::from_rgb565(code));
    for (int y = 0; y < 128; y += 32) display.flush({0, y, 128, 32}, sent.data() + 128 * y, 128 * 32 * 2, y == 96);
    EXPECT_EQ(model.complaint, "");
    EXPECT_TRUE(model.memory == codes);
}

}  // namespace
}  // namespace shade16::displays
