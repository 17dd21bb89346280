// spidev on a model of the kernel's side: a buffer of so many bytes, transfers that are short or interrupted, a device that goes.
#include <gtest/gtest.h>
#include <linux/spi/spidev.h>

#include <cerrno>
#include <random>
#include <vector>

#include "boards/linux_spi/spidev.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using linux_spi::Spidev;

/// The kernel, with a device that keeps what it is sent.
class Model final : public linux_spi::SystemCalls {
public:
    std::size_t buffer = 4096, told = 4096;
    int open_error = 0, mode_error = 0;
    uint8_t mode = 0;  // as the driver has it
    std::vector<uint8_t> sent{};
    std::vector<std::size_t> messages{};
    std::vector<uint32_t> clocks{};
    int open_files = 0;
    std::vector<int> answers{};  // of the next messages: a negative error, a length, or 0 for all of it

    int open(const std::string&) override {
        if (open_error != 0) return -open_error;
        ++open_files;
        return 7;
    }
    void close(int file) override {
        EXPECT_EQ(file, 7);
        --open_files;
    }
    int ioctl(int, unsigned long request, void* argument) override {
        if (request == SPI_IOC_RD_MODE) return *static_cast<uint8_t*>(argument) = mode, 0;
        if (request == SPI_IOC_WR_MODE && mode_error == 0) mode = *static_cast<uint8_t*>(argument);
        if (request == SPI_IOC_WR_MODE) return -mode_error;
        if (request != SPI_IOC_MESSAGE(1)) return 0;
        const auto& message = *static_cast<spi_ioc_transfer*>(argument);
        if (message.len > buffer) return -EMSGSIZE;
        int answer = 0;
        if (!answers.empty()) answer = answers.front(), answers.erase(answers.begin());
        if (answer < 0) return answer;
        const auto* bytes = reinterpret_cast<const uint8_t*>(message.tx_buf);
        const std::size_t count = answer == 0 ? message.len : std::min<std::size_t>(message.len, static_cast<std::size_t>(answer));
        sent.insert(sent.end(), bytes, bytes + count);
        messages.push_back(count);
        clocks.push_back(message.speed_hz);
        return static_cast<int>(count);
    }
    long write_at(int, const void*, std::size_t, long) override { return -EBADF; }
    void sleep_ms(uint32_t) override {}
    std::optional<std::string> text_of(const std::string& path) override {
        EXPECT_EQ(path, "/sys/module/spidev/parameters/bufsiz");
        if (told == 0) return std::nullopt;
        return std::to_string(told) + "\n";
    }
};

std::vector<uint8_t> noise(std::size_t count) {
    std::mt19937 engine(5);
    std::vector<uint8_t> bytes(count);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(engine());
    return bytes;
}

TEST(Spidev, MessagesFitTheBufferAndEndWithRows) {
    Model model;
    const std::vector<uint8_t> bytes = noise(480 * 40);
    Spidev spi(model, {});
    spi.set_row_bytes(480);
    spi.send(bytes.data(), bytes.size());
    EXPECT_EQ(model.sent, bytes);
    EXPECT_EQ(model.messages, (std::vector<std::size_t>{3840, 3840, 3840, 3840, 3840}));
}

TEST(Spidev, ARowThatDoesNotFitIsSplitWhereTheBufferEnds) {
    Model model;
    const std::vector<uint8_t> bytes = noise(10'000);
    Spidev spi(model, {});
    spi.set_row_bytes(5000);
    spi.send(bytes.data(), bytes.size());
    EXPECT_EQ(model.sent, bytes);
    EXPECT_EQ(model.messages, (std::vector<std::size_t>{4096, 4096, 1808}));
}

TEST(Spidev, ALargerBufferIsUsedAndOneThatIsNotToldIsTheUsual) {
    Model large;
    large.buffer = large.told = 65536;
    EXPECT_EQ(Spidev(large, {}).message_bytes(), 65536u);
    Model silent;
    silent.told = 0;
    EXPECT_EQ(Spidev(silent, {}).message_bytes(), 4096u);
}

TEST(Spidev, ABufferSmallerThanItSaysIsFoundOut) {
    Model model;
    model.buffer = 1000;
    const std::vector<uint8_t> bytes = noise(5000);
    Spidev spi(model, {});
    spi.send(bytes.data(), bytes.size());
    EXPECT_EQ(model.sent, bytes);
    EXPECT_EQ(spi.message_bytes(), 512u);
}

TEST(Spidev, WhatIsInterruptedOrShortGoesOnWhereItEnded) {
    Model model;
    model.answers = {-EINTR, 100, -EAGAIN, 1, 0, -EINTR, -EINTR, 3000};
    const std::vector<uint8_t> bytes = noise(12'000);
    Spidev spi(model, {});
    spi.send(bytes.data(), bytes.size());
    EXPECT_EQ(model.sent, bytes);
}

TEST(Spidev, BeginsSlowly) {
    Model model;
    const std::vector<uint8_t> bytes = noise(10);
    Spidev spi(model, {.hz = 32'000'000});
    spi.send(bytes.data(), bytes.size());
    spi.run_at_full_speed();
    spi.send(bytes.data(), bytes.size());
    EXPECT_EQ(model.clocks, (std::vector<uint32_t>{4'000'000, 32'000'000}));
}

TEST(Spidev, ChangesTheModeOnlyWhereItMustAndLeavesItsOtherBits) {
    Model model;
    model.mode = SPI_CS_HIGH, model.mode_error = EINVAL;  // a driver that takes no change
    EXPECT_EQ(complaint([&] { Spidev spi(model, {.mode = 0}); }), "no complaint");
    EXPECT_EQ(complaint([&] { Spidev spi(model, {.mode = 3}); }), "3: /dev/spidev0.0: does not take its mode: Invalid argument.");
    model.mode_error = 0;
    const Spidev spi(model, {.mode = 3});
    EXPECT_EQ(model.mode, SPI_CS_HIGH | SPI_MODE_3);
}

TEST(Spidev, SaysWhatMendsIt) {
    Model model;
    model.open_error = ENOENT;
    EXPECT_EQ(complaint([&] { Spidev spi(model, {}); }),
              "3: /dev/spidev0.0: there is no such device; on a Raspberry Pi, 'echo dtparam=spi=on | sudo tee -a /boot/firmware/config.txt' and a restart bring it.");
    EXPECT_EQ(complaint([&] { Spidev spi(model, {.device = "/dev/spidev1.2"}); }),
              "3: /dev/spidev1.2: there is no such device; on a Raspberry Pi, 'echo dtoverlay=spi1-3cs | sudo tee -a /boot/firmware/config.txt' and a restart bring it.");
    model.open_error = EACCES;
    EXPECT_EQ(complaint([&] { Spidev spi(model, {.device = "/dev/spidev8.0"}); }),  // permission_denied knows the group of one that exists
              "3: SPI: /dev/spidev8.0 is open to root alone; 'sudo chgrp spi /dev/spidev8.0' and 'sudo chmod g+rw /dev/spidev8.0' (or a udev rule that does so at "
              "every start), 'sudo adduser $USER spi' and a new login mend it.");
    model.open_error = EBUSY;
    EXPECT_EQ(complaint([&] { Spidev spi(model, {}); }), "3: /dev/spidev0.0: cannot be opened: Device or resource busy.");
    EXPECT_EQ(model.open_files, 0);
}

TEST(Spidev, ADeviceThatGoesOrNeverTakesAnythingEndsInASentence) {
    Model model;
    const std::vector<uint8_t> bytes = noise(100);
    {
        Spidev spi(model, {});
        model.answers = {10, -ENODEV};
        EXPECT_EQ(complaint([&] { spi.send(bytes.data(), bytes.size()); }), "3: /dev/spidev0.0: the device has gone; expected it to stay while frames are sent.");
        model.answers.assign(2000, -EAGAIN);
        EXPECT_EQ(complaint([&] { spi.send(bytes.data(), bytes.size()); }), "3: /dev/spidev0.0: 100 bytes were not sent: Resource temporarily unavailable.");
        model.answers = {-EIO};
        EXPECT_EQ(complaint([&] { spi.send(bytes.data(), bytes.size()); }), "3: /dev/spidev0.0: 100 bytes were not sent: Input/output error.");
    }
    EXPECT_EQ(model.open_files, 0);
}

}  // namespace
}  // namespace shade16::host
