// A kernel's framebuffer as a model: its layout, its rows, and what it may refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/fb.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>

#include "host_sim/screen/framebuffer.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

/// Memory of some rows; a write takes what is asked for, or seven bytes, or is interrupted.
class Model final : public linux_spi::SystemCalls {
public:
    fb_var_screeninfo screen{};
    fb_fix_screeninfo memory{};
    std::vector<uint8_t> bytes{};
    int open_error = 0, open_files = 0, writes = 0;
    bool is_framebuffer = true, is_slow = false, is_gone = false;

    Model(uint32_t width, uint32_t height, uint32_t bits, uint32_t row_bytes) {
        screen.xres = width, screen.yres = height, screen.bits_per_pixel = bits;
        if (bits == 16) screen.red = {11, 5, 0}, screen.green = {5, 6, 0}, screen.blue = {0, 5, 0};
        else screen.red = {16, 8, 0}, screen.green = {8, 8, 0}, screen.blue = {0, 8, 0};
        memory.line_length = row_bytes;
        bytes.resize(std::size_t{row_bytes} * (height + 4), 0xEE);
    }
    int open(const std::string&) override {
        if (open_error != 0) return -open_error;
        ++open_files;
        return 3;
    }
    void close(int) override { --open_files; }
    int ioctl(int, unsigned long request, void* argument) override {
        if (!is_framebuffer) return -ENOTTY;
        if (request == FBIOGET_VSCREENINFO) std::memcpy(argument, &screen, sizeof(screen));
        else std::memcpy(argument, &memory, sizeof(memory));
        return 0;
    }
    long write_at(int, const void* from, std::size_t count, long at) override {
        ++writes;
        if (is_gone) return -ENODEV;
        if (is_slow && writes % 3 == 0) return -EINTR;
        if (is_slow) count = std::min<std::size_t>(count, 7);
        EXPECT_LE(static_cast<std::size_t>(at) + count, bytes.size());
        std::memcpy(bytes.data() + at, from, count);
        return static_cast<long>(count);
    }
    void sleep_ms(uint32_t) override {}
    std::optional<std::string> text_of(const std::string&) override { return std::nullopt; }
};

Image noise(int width, int height) {
    Image image{width, height, {}, {}, 0};
    std::mt19937 engine(9);
    for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<uint8_t>(engine()));
    for (int i = 0; i < 2 * width * height; ++i) image.raw.push_back(static_cast<uint8_t>(engine()));
    return image;
}

void expect_shown(const Model& model, const Image& image, std::size_t first) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y * image.width + x);
            const uint8_t* const row = model.bytes.data() + first + static_cast<std::size_t>(y) * model.memory.line_length;
            if (model.screen.bits_per_pixel == 16) {
                ASSERT_EQ(std::memcmp(row + 2 * x, image.raw.data() + 2 * pixel, 2), 0) << x << ", " << y;
            } else {
                const uint8_t* const rgb = image.rgb.data() + 3 * pixel;
                const uint8_t expected[4] = {rgb[2], rgb[1], rgb[0], 0};
                ASSERT_EQ(std::memcmp(row + 4 * x, expected, 4), 0) << x << ", " << y;
            }
        }
}

TEST(Framebuffer, RowsStandWhereTheKernelHasThem) {
    for (const uint32_t bits : {16u, 32u}) {
        Model model(33, 17, bits, 160);
        model.screen.xoffset = 2, model.screen.yoffset = 3;
        model.is_slow = true;
        Framebuffer screen(model, "/dev/fb0", "");
        EXPECT_STREQ(screen.format(), bits == 16 ? "rgb565" : "rgb888");
        const Image image = noise(33, 17);
        screen.show(image);
        expect_shown(model, image, 3 * 160 + 2 * bits / 8);
        EXPECT_EQ(screen.figures().bytes, 33u * 17 * bits / 8);
        EXPECT_EQ(std::count(model.bytes.begin(), model.bytes.begin() + 480, 0xEE), 480) << "nothing above the screen";
    }
}

TEST(Framebuffer, OnlyRowsThatChangedAreWritten) {
    Model model(33, 17, 16, 66);
    Framebuffer screen(model, "/dev/fb0", "");
    Image image = noise(33, 17);
    screen.show(image);
    screen.show(image);
    EXPECT_EQ(model.writes, 17);
    image.raw[66 * 5] ^= 1, image.raw[66 * 16 + 65] ^= 1;
    screen.show(image);
    EXPECT_EQ(model.writes, 19);
    expect_shown(model, image, 0);
}

TEST(Framebuffer, HidesTheConsolesCursorMeanwhile) {
    const ScratchDirectory scratch;
    const std::string console = scratch.write("tty0", "");
    Model model(32, 16, 16, 64);
    {
        Framebuffer screen(model, "/dev/fb0", console);
        EXPECT_EQ(scratch.read("tty0"), "\033[?25l");
    }
    EXPECT_EQ(scratch.read("tty0"), "\033[?25l\033[?25h");
}

TEST(Framebuffer, SaysWhatItCannotUse) {
    Model model(32, 16, 16, 64);
    const auto open = [&] { Framebuffer screen(model, "/dev/fb0", ""); };
    model.open_error = EACCES;
    EXPECT_THAT(complaint(open), testing::AllOf(testing::StartsWith("3: framebuffer: /dev/fb0 is open to "), testing::HasSubstr("'sudo adduser $USER video'")));
    model.open_error = ENOENT;
    EXPECT_EQ(complaint(open), "3: /dev/fb0: there is no such framebuffer; expected one of /dev/fb*.");
    model.open_error = 0, model.is_framebuffer = false;
    EXPECT_EQ(complaint(open), "3: /dev/fb0: is no framebuffer; expected one of /dev/fb*.");
    model.is_framebuffer = true, model.screen.bits_per_pixel = 24;
    EXPECT_EQ(complaint(open), "3: /dev/fb0: has pixels of 24 bits in an order that shade16 does not know; expected RGB565 or XRGB8888.");
    model.screen.bits_per_pixel = 16, model.memory.line_length = 63;
    EXPECT_EQ(complaint(open), "3: /dev/fb0: says that it shows 32x16 pixels in rows of 63 bytes; expected rows that hold its pixels.");
    model.memory.line_length = 64, model.is_gone = true;
    EXPECT_EQ(complaint([&] {
                  Framebuffer screen(model, "/dev/fb0", "");
                  screen.show(noise(32, 16));
              }),
              "3: /dev/fb0: the framebuffer has gone; expected it to stay while frames are shown.");
    EXPECT_EQ(model.open_files, 0);
}

}  // namespace
}  // namespace shade16::host
