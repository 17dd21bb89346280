// The kernel's framebuffer, /dev/fb0: RGB565 or XRGB8888, in rows as long as the kernel says.
// Source: the kernel's Documentation/fb/api.rst.
#pragma once

#include <string>

#include "host_sim/screen/changed_rows.hpp"
#include "host_sim/screen/hidden_cursor.hpp"
#include "host_sim/screen/screen.hpp"
#include "boards/linux_spi/system_calls.hpp"

namespace shade16::host {

class Framebuffer final : public Screen {
public:
    /// `console` is what has a cursor on it.
    Framebuffer(linux_spi::SystemCalls& system, const std::string& device, const std::string& console);
    ~Framebuffer() override;

    Viewport size() const override { return size_; }
    const char* format() const override { return bytes_a_pixel_ == 2 ? Rgb565::name : Rgb888::name; }

    std::size_t send(const Image& frame) override;

private:
    void ask_for_layout();
    void write(const std::vector<uint8_t>& row, long at);

    linux_spi::SystemCalls& system_;
    std::string device_;
    int file_ = -1;
    Viewport size_{};
    std::size_t bytes_a_pixel_ = 0;
    long first_ = 0, row_bytes_ = 0;  // of the memory: where the screen begins, and from a row to the next
    ChangedRows changed_{};
    HiddenCursor cursor_;
};

}  // namespace shade16::host
