// The kernel behind /dev/spidev0.0, and a display behind that: it takes messages while the stubs' lines say what they are.
#pragma once

#include <linux/spi/spidev.h>

#include <cerrno>
#include <functional>
#include <optional>

#include "boards/linux_spi/system_calls.hpp"
#include "tests/displays/dcs_model.hpp"
#include "tests/linux/fake_gpio.hpp"

namespace shade16::linux_spi {

class KernelModel final : public SystemCalls {
public:
    /// What becomes of the next message: a negative error, or how many of its bytes go out.
    using Fate = std::function<int(std::size_t bytes)>;

    KernelModel(const DcsPanel& panel, std::size_t buffer_bytes) : panel_(panel), buffer_bytes_(buffer_bytes) {
        fake.changed = [this](const FakeLine& line) {
            if (line.name == "GPIO27") display_->reset_line(line.value);
        };
        plug_in();
    }
    ~KernelModel() override { fake.changed = nullptr; }

    /// A display that has just got its supply.
    void plug_in() { display_.emplace(panel_); }
    displays::DcsModel& display() { return *display_; }

    Fate fate = [](std::size_t bytes) { return static_cast<int>(bytes); };
    int open_error = 0, open_files = 0;
    /// Files that are open stay dead when it is back.
    void take_away() { open_error = ENOENT, ++removals_; }
    void bring_back() { open_error = 0; }

    int open(const std::string&) override {
        if (open_error != 0) return -open_error;
        ++open_files;
        return removals_;
    }
    void close(int) override { --open_files; }
    int ioctl(int file, unsigned long request, void* argument) override {
        if (file != removals_) return -ESHUTDOWN;
        if (request != SPI_IOC_MESSAGE(1)) return 0;
        const auto& message = *static_cast<const spi_ioc_transfer*>(argument);
        if (message.len > buffer_bytes_) return -EMSGSIZE;
        const int result = fate(message.len);
        for (int i = 0; i < result; ++i) take(reinterpret_cast<const uint8_t*>(message.tx_buf)[i]);
        return result;
    }
    long write_at(int, const void*, std::size_t, long) override { return -EBADF; }
    void sleep_ms(uint32_t ms) override { display_->delay_ms(ms); }
    std::optional<std::string> text_of(const std::string&) override { return std::to_string(buffer_bytes_); }
    /// A byte that arrives while the data/command line says what it is.
    void take(uint8_t byte) {
        if (fake.chips.at("gpiochip0").lines.at(25).value) display_->data(byte);
        else display_->command(byte);
    }

private:
    const DcsPanel& panel_;
    std::size_t buffer_bytes_;
    int removals_ = 0;
    std::optional<displays::DcsModel> display_{};
};

}  // namespace shade16::linux_spi
