#include "tests/linux/guest/on_spidev.hpp"

#include "tests/linux/guest/drawing.hpp"
#include "tests/linux/guest/recorded_panel.hpp"

namespace shade16::linux_spi {

namespace {

/// The kernel's, but for small files, of which there is none.
class WithoutFiles final : public SystemCalls {
public:
    int open(const std::string& path) override { return kernel_.open(path); }
    void close(int file) override { kernel_.close(file); }
    int ioctl(int file, unsigned long request, void* argument) override { return kernel_.ioctl(file, request, argument); }
    long write_at(int file, const void* bytes, std::size_t count, long at) override { return kernel_.write_at(file, bytes, count, at); }
    void sleep_ms(uint32_t ms) override { kernel_.sleep_ms(ms); }
    std::optional<std::string> text_of(const std::string&) override { return std::nullopt; }

private:
    SystemCalls& kernel_ = system_calls();
};

uint8_t mode_of(const std::string& how) {
    if (how == "mode_0" || how == "untold") return 0;
    if (how == "mode_3") return 3;
    throw host::input_error("show_on_spidev: '{}'; expected mode_0, mode_3 or untold.", how);
}

}  // namespace

int show_on_spidev(const std::string& device, const std::string& how) {
    const SpidevSettings settings{.device = device, .mode = mode_of(how)};
    WithoutFiles without_files;
    SystemCalls& system = how == "untold" ? without_files : system_calls();
    std::printf("messages of at most %zu bytes are expected to fit\n", Spidev(system, settings).message_bytes());
    RecordedPanel panel;
    const int code = show_once(panel, [&] { return PanelOnSpidev(panel, system, settings); });
    std::printf("the longest message: %ld bytes", panel.most_bytes_at_once());
    std::printf(", the clock rests: %s\n", panel.clock_rests_high() ? "high" : "low");
    std::printf("select or data/command changed in a byte: %s\n", panel.was_interrupted() ? "yes" : "no");
    return code;
}

int draw_on_spidev(const std::string& device) {
    RecordedPanel panel;
    return draw_until_stopped(panel, [&] { return PanelOnSpidev(panel, system_calls(), {.device = device}); });
}

int try_spidev(const std::string& device, unsigned mode) {
    const Spidev spi(system_calls(), {.device = device, .mode = static_cast<uint8_t>(mode)});
    std::printf("%s was opened in mode %u\n", device.c_str(), mode);
    return 0;
}

}  // namespace shade16::linux_spi
