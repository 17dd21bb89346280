#include "boards/linux_spi/spidev.hpp"

#include <linux/spi/spidev.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

#include "boards/linux_spi/device_gone.hpp"
#include "boards/linux_spi/permission.hpp"

namespace shade16::linux_spi {

namespace {

constexpr std::size_t usual_buffer_bytes = 4096, least_message_bytes = 64;
constexpr const char* buffer_file = "/sys/module/spidev/parameters/bufsiz";
constexpr int most_tries = 1000;  // of a message that the kernel puts off

std::size_t buffer_bytes(SystemCalls& system) {
    const std::string text = system.text_of(buffer_file).value_or("");
    std::size_t bytes = 0;
    std::from_chars(text.data(), text.data() + text.size(), bytes);
    return bytes < least_message_bytes ? usual_buffer_bytes : bytes;
}

/// The line of a Raspberry Pi's configuration that brings a device, /dev/spidev<bus>.<select>; empty where none is known.
/// Source: Raspberry Pi's boot/overlays/README, spi<bus>-<number of selects>cs.
std::string overlay_of(const std::string& device) {
    unsigned bus = 0, select = 0;
    char rest = 0;
    if (std::sscanf(device.c_str(), "/dev/spidev%u.%u%c", &bus, &select, &rest) != 2) return "";
    if (bus == 0) return select < 2 ? "dtparam=spi=on" : "";
    const unsigned selects = bus == 1 ? 3 : bus <= 6 ? 2 : 0;
    return select < selects ? fmt::format("dtoverlay=spi{}-{}cs", bus, select + 1) : "";
}

host::Error no_such_device(const std::string& device) {
    const std::string overlay = overlay_of(device);
    if (overlay.empty()) return host::io_error("{}: there is no such device; expected one of /dev/spidev*.", device);
    return host::io_error("{}: there is no such device; on a Raspberry Pi, 'echo {} | sudo tee -a /boot/firmware/config.txt' and a restart bring it.", device,
                          overlay);
}

host::Error cannot_open(const std::string& device, int error) {
    if (error == ENOENT || error == ENXIO) return no_such_device(device);
    if (error == EACCES || error == EPERM) return permission_denied("SPI", device, "spi");
    return host::io_error("{}: cannot be opened: {}.", device, std::strerror(error));
}

}  // namespace

Spidev::Spidev(SystemCalls& system, SpidevSettings settings)
    : system_(system), settings_(std::move(settings)), hz_(std::min(settings_.hz, beginning_hz)), most_bytes_(buffer_bytes(system)) {
    file_ = system_.open(settings_.device);
    if (file_ < 0) throw cannot_open(settings_.device, -file_);
    uint8_t bits = 8;
    try {
        set_mode();
        set(SPI_IOC_WR_BITS_PER_WORD, &bits, "words of eight bits");
        set(SPI_IOC_WR_MAX_SPEED_HZ, &settings_.hz, "its clock");
    } catch (...) {
        system_.close(file_);
        throw;
    }
}

Spidev::~Spidev() { system_.close(file_); }

void Spidev::set(unsigned long request, void* value, const char* what) {
    const int result = system_.ioctl(file_, request, value);
    if (result == -ENOTTY) throw host::io_error("{}: is no spidev device; expected one of /dev/spidev*.", settings_.device);
    if (result < 0) throw host::io_error("{}: does not take {}: {}.", settings_.device, what, std::strerror(-result));
}

/// Only where it is another one, and the device's other bits stay: some drivers take no change at all.
void Spidev::set_mode() {
    constexpr uint8_t clock_bits = SPI_CPOL | SPI_CPHA;
    uint8_t mode = 0;
    const bool known = system_.ioctl(file_, SPI_IOC_RD_MODE, &mode) >= 0;
    if (known && (mode & clock_bits) == settings_.mode) return;
    mode = static_cast<uint8_t>((mode & ~clock_bits) | settings_.mode);
    set(SPI_IOC_WR_MODE, &mode, "its mode");
}

std::size_t Spidev::next_message(std::size_t left) const {
    if (left <= most_bytes_) return left;
    return row_bytes_ != 0 && row_bytes_ <= most_bytes_ ? most_bytes_ - most_bytes_ % row_bytes_ : most_bytes_;
}

int Spidev::transfer(const uint8_t* bytes, std::size_t count) {
    spi_ioc_transfer message{};
    message.tx_buf = reinterpret_cast<uintptr_t>(bytes);
    message.len = static_cast<uint32_t>(count);
    message.speed_hz = hz_;
    message.bits_per_word = 8;
    return system_.ioctl(file_, SPI_IOC_MESSAGE(1), &message);
}

void Spidev::send(const uint8_t* bytes, std::size_t count) {
    for (int tries = 0; count != 0;) {
        const int result = transfer(bytes, next_message(count));
        if (result > 0) {
            bytes += result, count -= static_cast<std::size_t>(result);
            tries = 0;
        } else if (result == -EMSGSIZE && most_bytes_ > least_message_bytes) {
            most_bytes_ /= 2;  // the kernel's buffer is smaller than it says
        } else if ((result == 0 || result == -EINTR || result == -EAGAIN) && tries < most_tries) {
            ++tries;
            if (result != -EINTR) system_.sleep_ms(1);  // it is busy: a second in all
        } else if (result == -ENODEV || result == -ESHUTDOWN || result == -ENXIO) {
            throw DeviceGone(host::io_error("{}: the device has gone; expected it to stay while frames are sent.", settings_.device));
        } else {
            throw host::io_error("{}: {} bytes were not sent: {}.", settings_.device, count, result == 0 ? "nothing went out" : std::strerror(-result));
        }
    }
}

}  // namespace shade16::linux_spi
