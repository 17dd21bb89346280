// A bus that is text: what a panel would be sent, a line a transaction, in the words of boards/panels.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <shade16/shade16.hpp>
#include <string>

namespace shade16::host {

class PrintedBus {
public:
    using Format = Rgb565Swapped;
    explicit PrintedBus(std::function<void(const std::string&)> print) : print_(std::move(print)) {}

    void reset() { say("reset"); }
    void command(uint8_t byte) {
        wait();
        line_ = fmt::format("command 0x{:02X}", byte);
    }
    void data(const uint8_t* bytes, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) line_ += fmt::format(" 0x{:02X}", bytes[i]);
    }
    void pixels(const uint16_t*, std::size_t count) {
        wait();
        say(fmt::format("pixels {}", count));
    }
    void wait() {
        if (!line_.empty()) say(line_);
        line_.clear();
    }
    void delay_ms(uint32_t ms) {
        wait();
        say(fmt::format("delay {}", ms));
    }

private:
    void say(const std::string& text) { print_(text + "\n"); }
    std::function<void(const std::string&)> print_;
    std::string line_{};
};

}  // namespace shade16::host
