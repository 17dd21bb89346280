// libgpiod 1: a line is a part of its chip. Source: gpiod.h 1.6.3.
#include <gpiod.h>

#include <cerrno>
#include <system_error>

#include "boards/linux_spi/gpio_port.hpp"

namespace shade16::linux_spi::gpio {

namespace {

/// What the library returned, or its errno.
template <class T>
T* checked(T* pointer) {
    if (pointer == nullptr) throw std::system_error(errno, std::generic_category());
    return pointer;
}
std::string text(const char* name) { return name == nullptr ? "" : name; }

}  // namespace

Chip::Chip(const std::string& path) : handle_(checked(gpiod_chip_open(path.c_str()))) {}
void Chip::Close::operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
std::string Chip::label() const { return text(gpiod_chip_label(handle_.get())); }
unsigned Chip::line_count() const { return gpiod_chip_num_lines(handle_.get()); }
LineInfo Chip::line(unsigned offset) const {
    gpiod_line* const line = checked(gpiod_chip_get_line(handle_.get(), offset));
    return {text(gpiod_line_name(line)), text(gpiod_line_consumer(line)), gpiod_line_is_used(line)};
}

Request::Request(Chip chip, unsigned offset, const Wish& wish) : chip_(std::move(chip)), offset_(offset) {
    gpiod_line* const line = checked(gpiod_chip_get_line(chip_.handle(), offset_));
    const int flags = wish.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
    if (gpiod_line_request_output_flags(line, wish.consumer.c_str(), flags, wish.initially) != 0)
        throw std::system_error(errno, std::generic_category());
    handle_.reset(line);
}
void Request::Release::operator()(void* request) const { gpiod_line_release(static_cast<gpiod_line*>(request)); }
void Request::set(bool on) {
    if (gpiod_line_set_value(static_cast<gpiod_line*>(handle_.get()), on) != 0) throw std::system_error(errno, std::generic_category());
}

}  // namespace shade16::linux_spi::gpio
