// libgpiod 2: a request is made of three descriptions, and outlives them. Source: gpiod.h 2.2.
#include <gpiod.h>

#include <cerrno>
#include <system_error>

#include "boards/linux_spi/gpio_port.hpp"

namespace shade16::linux_spi::gpio {

namespace {

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category()); }

/// A thing of the library's that ends with its own function; what the library refused to make is its errno.
template <class T, auto free>
class Owned {
public:
    explicit Owned(T* made) : made_(made) {
        if (made == nullptr) fail();
    }
    operator T*() const { return made_.get(); }

private:
    struct Free {
        void operator()(T* made) const { free(made); }
    };
    std::unique_ptr<T, Free> made_;
};
using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using OwnedLineInfo = Owned<gpiod_line_info, gpiod_line_info_free>;
using LineSettings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;

std::string text(const char* name) { return name == nullptr ? "" : name; }
gpiod_line_value value_of(bool on) { return on ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE; }

gpiod_line_request* request_of(gpiod_chip* chip, unsigned offset, const Wish& wish) {
    const LineSettings settings(gpiod_line_settings_new());
    if (gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT) != 0) fail();
    gpiod_line_settings_set_active_low(settings, wish.active_low);
    if (gpiod_line_settings_set_output_value(settings, value_of(wish.initially)) != 0) fail();
    const LineConfig lines(gpiod_line_config_new());
    if (gpiod_line_config_add_line_settings(lines, &offset, 1, settings) != 0) fail();
    const RequestConfig config(gpiod_request_config_new());
    gpiod_request_config_set_consumer(config, wish.consumer.c_str());
    gpiod_line_request* const request = gpiod_chip_request_lines(chip, config, lines);
    if (request == nullptr) fail();
    return request;
}

}  // namespace

Chip::Chip(const std::string& path) : handle_(gpiod_chip_open(path.c_str())) {
    if (handle_ == nullptr) fail();
}
void Chip::Close::operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
std::string Chip::label() const { return text(gpiod_chip_info_get_label(ChipInfo(gpiod_chip_get_info(handle_.get())))); }
unsigned Chip::line_count() const {
    return static_cast<unsigned>(gpiod_chip_info_get_num_lines(ChipInfo(gpiod_chip_get_info(handle_.get()))));
}
LineInfo Chip::line(unsigned offset) const {
    const OwnedLineInfo info(gpiod_chip_get_line_info(handle_.get(), offset));
    return {text(gpiod_line_info_get_name(info)), text(gpiod_line_info_get_consumer(info)), gpiod_line_info_is_used(info)};
}

Request::Request(Chip chip, unsigned offset, const Wish& wish)
    : chip_(std::move(chip)), offset_(offset), handle_(request_of(chip_.handle(), offset, wish)) {}
void Request::Release::operator()(void* request) const { gpiod_line_request_release(static_cast<gpiod_line_request*>(request)); }
void Request::set(bool on) {
    if (gpiod_line_request_set_value(static_cast<gpiod_line_request*>(handle_.get()), offset_, value_of(on)) != 0) fail();
}

}  // namespace shade16::linux_spi::gpio
