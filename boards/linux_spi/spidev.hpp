// SPI through the kernel's spidev: /dev/spidev<bus>.<select>.
// Source: the kernel's Documentation/spi/spidev.rst and drivers/spi/spidev.c.
#pragma once

#include <string>

#include "boards/linux_spi/byte_sender.hpp"
#include "boards/linux_spi/system_calls.hpp"

namespace shade16::linux_spi {

struct SpidevSettings {
    std::string device = "/dev/spidev0.0";
    uint32_t hz = 32'000'000;
    uint8_t mode = 0;  // 0, or 3 for panels without a select line
};

class Spidev final : public ByteSender {
public:
    /// Opens the device. Until `run_at_full_speed` it sends at 4 MHz at most, so that a panel begins even if its clock is too fast for pictures.
    Spidev(SystemCalls& system, SpidevSettings settings);
    ~Spidev() override;

    /// In messages that the kernel takes. One that is interrupted is sent again from where it ended.
    void send(const uint8_t* bytes, std::size_t count) override;
    /// Messages end with a row where a row fits one.
    void set_row_bytes(std::size_t bytes) { row_bytes_ = bytes; }
    void run_at_full_speed() { hz_ = settings_.hz; }

    /// The most bytes of a message.
    std::size_t message_bytes() const { return most_bytes_; }

private:
    static constexpr uint32_t beginning_hz = 4'000'000;

    void set_mode();
    void set(unsigned long request, void* value, const char* what);
    std::size_t next_message(std::size_t left) const;
    int transfer(const uint8_t* bytes, std::size_t count);

    SystemCalls& system_;
    SpidevSettings settings_;
    int file_ = -1;
    uint32_t hz_ = 0;
    std::size_t most_bytes_ = 0, row_bytes_ = 0;
};

}  // namespace shade16::linux_spi
