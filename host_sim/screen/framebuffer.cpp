#include "host_sim/screen/framebuffer.hpp"

#include <linux/fb.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "boards/linux_spi/device_gone.hpp"
#include "boards/linux_spi/permission.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

bool is(const fb_bitfield& field, uint32_t offset, uint32_t length) { return field.offset == offset && field.length == length; }
bool is_rgb565(const fb_var_screeninfo& v) { return v.bits_per_pixel == 16 && is(v.red, 11, 5) && is(v.green, 5, 6) && is(v.blue, 0, 5); }
bool is_xrgb8888(const fb_var_screeninfo& v) { return v.bits_per_pixel == 32 && is(v.red, 16, 8) && is(v.green, 8, 8) && is(v.blue, 0, 8); }

Error cannot_open(const std::string& device, int error) {
    if (error == ENOENT) return io_error("{}: there is no such framebuffer; expected one of /dev/fb*.", device);
    if (error == EACCES || error == EPERM) return linux_spi::permission_denied("framebuffer", device, "video");
    return io_error("{}: cannot be opened: {}.", device, std::strerror(error));
}

/// Three bytes a pixel, red first, as four: blue, green, red and nothing.
std::vector<uint8_t> as_xrgb8888(const uint8_t* rgb, int width) {
    std::vector<uint8_t> row;
    row.reserve(4 * static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x, rgb += 3) row.insert(row.end(), {rgb[2], rgb[1], rgb[0], 0});
    return row;
}

}  // namespace

Framebuffer::Framebuffer(linux_spi::SystemCalls& system, const std::string& device, const std::string& console)
    : system_(system), device_(device), file_(system.open(device)), cursor_(console) {
    if (file_ < 0) throw cannot_open(device_, -file_);
    try {
        ask_for_layout();
    } catch (...) {
        system_.close(file_);
        throw;
    }
}

Framebuffer::~Framebuffer() { system_.close(file_); }

void Framebuffer::ask_for_layout() {
    fb_var_screeninfo screen{};
    fb_fix_screeninfo memory{};
    if (system_.ioctl(file_, FBIOGET_VSCREENINFO, &screen) < 0 || system_.ioctl(file_, FBIOGET_FSCREENINFO, &memory) < 0)
        throw io_error("{}: is no framebuffer; expected one of /dev/fb*.", device_);
    if (!is_rgb565(screen) && !is_xrgb8888(screen))
        throw io_error("{}: has pixels of {} bits in an order that shade16 does not know; expected RGB565 or XRGB8888.", device_, screen.bits_per_pixel);
    bytes_a_pixel_ = screen.bits_per_pixel / 8;
    // What is larger than the engine draws is drawn at its top left.
    size_ = {static_cast<int32_t>(std::min<uint32_t>(screen.xres, max_target_px)), static_cast<int32_t>(std::min<uint32_t>(screen.yres, max_target_px))};
    row_bytes_ = static_cast<long>(memory.line_length);
    if (size_.width <= 0 || size_.height <= 0 || row_bytes_ < static_cast<long>(bytes_a_pixel_) * size_.width)
        throw io_error("{}: says that it shows {}x{} pixels in rows of {} bytes; expected rows that hold its pixels.", device_, screen.xres, screen.yres, row_bytes_);
    first_ = static_cast<long>(screen.yoffset) * row_bytes_ + static_cast<long>(screen.xoffset) * static_cast<long>(bytes_a_pixel_);
}

void Framebuffer::write(const std::vector<uint8_t>& row, long at) {
    for (std::size_t done = 0; done < row.size();) {
        const long result = system_.write_at(file_, row.data() + done, row.size() - done, at + static_cast<long>(done));
        if (result == -EINTR) continue;
        if (result == -ENODEV) throw linux_spi::DeviceGone(io_error("{}: the framebuffer has gone; expected it to stay while frames are shown.", device_));
        if (result <= 0) throw io_error("{}: a row was not written: {}.", device_, result == 0 ? "nothing went in" : std::strerror(static_cast<int>(-result)));
        done += static_cast<std::size_t>(result);
    }
}

std::size_t Framebuffer::send(const Image& frame) {
    std::size_t sent = 0;
    const bool is_wide = bytes_a_pixel_ == 4;
    const std::vector<uint8_t>& pixels = is_wide ? frame.rgb : frame.raw;
    const std::size_t source_row = pixels.size() / static_cast<std::size_t>(frame.height);
    for (const RowRun run : changed_.of(pixels, frame.height))
        for (int y = run.first; y < run.first + run.count; ++y) {
            const uint8_t* const from = pixels.data() + static_cast<std::size_t>(y) * source_row;
            const std::vector<uint8_t> row = is_wide ? as_xrgb8888(from, frame.width) : std::vector<uint8_t>(from, from + source_row);
            write(row, first_ + y * row_bytes_);
            sent += row.size();
        }
    changed_.are_sent(pixels);
    return sent;
}

}  // namespace shade16::host
