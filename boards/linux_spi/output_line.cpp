#include "boards/linux_spi/output_line.hpp"

#include <cerrno>
#include <system_error>

#include "boards/linux_spi/device_gone.hpp"
#include "boards/linux_spi/find_line.hpp"
#include "boards/linux_spi/permission.hpp"
#include "host_sim/error.hpp"

namespace shade16::linux_spi {

namespace {

/// Who holds a line, as they called themselves.
std::string holder_of(const Place& place) {
    try {
        return gpio::Chip(place.chip).line(place.offset).consumer;
    } catch (const std::system_error&) {
        return "";  // what matters is that somebody does
    }
}

host::Error busy(const std::string& wanted, const Place& place) {
    const std::string holder = holder_of(place);
    return host::io_error("line '{}' ({}, line {}) is busy: {} holds it; end that, or choose another line.", wanted, place.chip, place.offset,
                          holder.empty() ? "another program" : "'" + holder + "'");
}

DeviceGone gone(const std::string& wanted, const std::string& chip) {
    return DeviceGone(host::io_error("line '{}': its chip {} is gone; expected it to stay plugged in while the display is driven.", wanted, chip));
}

host::Error refused(int number, const std::string& wanted, const Place& place) {
    if (number == EBUSY) return busy(wanted, place);
    if (number == EACCES || number == EPERM) return permission_denied("line '" + wanted + "'", place.chip, "gpio");
    if (number == ENODEV) return gone(wanted, place.chip);
    return host::io_error("line '{}' ({}, line {}) cannot be an output: {}; expected a line that can.", wanted, place.chip, place.offset,
                          std::generic_category().message(number));
}

void expect_line(const gpio::Chip& chip, const std::string& wanted, const Place& place) {
    const unsigned count = chip.line_count();
    if (place.offset >= count)
        throw host::input_error("line '{}': {} has no line {}; expected 0 to {}.", wanted, place.chip, place.offset, count - 1);
}

std::unique_ptr<gpio::Request> request_of(const std::string& wanted, const Place& place, const LineOptions& options) {
    gpio::Chip chip = open_chip(place.chip, wanted, options.devices);
    try {
        expect_line(chip, wanted, place);
        return std::make_unique<gpio::Request>(std::move(chip), place.offset, gpio::Wish{options.consumer, options.active_low, options.initially});
    } catch (const std::system_error& error) {
        throw refused(error.code().value(), wanted, place);
    }
}

}  // namespace

OutputLine::OutputLine(const std::string& wanted, const LineOptions& options) : wanted_(wanted) {
    const Place place = find_line(wanted, options.devices);
    chip_ = place.chip;
    request_ = request_of(wanted, place, options);
}

void OutputLine::set(bool on) {
    try {
        request_->set(on);
    } catch (const std::system_error& error) {
        if (error.code().value() == ENODEV) throw gone(wanted_, chip_);
        throw host::io_error("line '{}' ({}) cannot be set: {}; expected an output.", wanted_, chip_, error.code().message());
    }
}

}  // namespace shade16::linux_spi
