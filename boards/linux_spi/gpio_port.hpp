// The few things that this board asks of libgpiod, the same for its two C APIs: gpio_port_v1.cpp and gpio_port_v2.cpp. What fails throws
// std::system_error with the kernel's errno; output_line.cpp makes a sentence of it.
#pragma once

#include <memory>
#include <string>

struct gpiod_chip;

namespace shade16::linux_spi::gpio {

struct LineInfo {
    std::string name{}, consumer{};
    bool used = false;
};

/// An open chip. A Request takes it along.
class Chip {
public:
    explicit Chip(const std::string& path);
    std::string label() const;
    unsigned line_count() const;
    LineInfo line(unsigned offset) const;
    gpiod_chip* handle() const { return handle_.get(); }

private:
    struct Close {
        void operator()(gpiod_chip* chip) const;
    };
    std::unique_ptr<gpiod_chip, Close> handle_;
};

struct Wish {
    std::string consumer{};
    bool active_low = false, initially = false;
};

/// A line as an output, until the destructor. It stays where it is: in v1 the line is a part of its chip, so the order of their ends matters.
class Request {
public:
    Request(Chip chip, unsigned offset, const Wish& wish);
    Request(const Request&) = delete;
    Request& operator=(const Request&) = delete;
    void set(bool on);

private:
    struct Release {
        void operator()(void* request) const;
    };
    Chip chip_;
    unsigned offset_;
    std::unique_ptr<void, Release> handle_;  // a gpiod_line in v1, a gpiod_line_request in v2; the first to go
};

}  // namespace shade16::linux_spi::gpio
