// Y4M: a text header, then planes of luma and chroma. Players and encoders open it without options, also from a pipe.
#include <algorithm>
#include <stdexcept>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/frame_writer.hpp"

namespace shade16::host {

namespace {

struct YCbCr {
    uint8_t y, cb, cr;
};

/// x * 2^-16 rounded half up, at most 255: only pure blue (Cb) and pure red (Cr) reach 255.5.
constexpr uint8_t rounded(int32_t x) { return static_cast<uint8_t>(std::min((x + 0x8000) >> 16, 255)); }

/// BT.601, full range: what readers assume of a Y4M stream that says XCOLORRANGE=FULL and nothing about its matrix.
/// Y = 0.299 R + 0.587 G + 0.114 B, Cb = 128 + (B - Y) / 1.772, Cr = 128 + (R - Y) / 1.402, in units of 2^-16. Each row
/// of coefficients sums to exactly 1 or 0, so that greys have no tint.
/// Error   half a code a plane, one code a channel after the way back; every 5-6-5 colour, rounded to the nearest,
///         comes back exactly.
constexpr YCbCr to_ycbcr(int32_t r, int32_t g, int32_t b) {
    constexpr int32_t middle = 128 << 16;
    return {rounded(19595 * r + 38470 * g + 7471 * b), rounded(middle - 11059 * r - 21709 * g + 32768 * b),
            rounded(middle + 32768 * r - 27439 * g - 5329 * b)};
}

class Y4mWriter final : public FrameWriter {
public:
    Y4mWriter(const std::string& path, int width, int height, int fps)
        : stream_(open_output(path)), width_(width), height_(height) {
        stream_->write(fmt::format("YUV4MPEG2 W{} H{} F{}:1 Ip A1:1 C444 XCOLORRANGE=FULL\n", width, height, fps));
    }

    void write(const Image& frame) override {
        const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        if (frame.width != width_ || frame.height != height_ || frame.rgb.size() != 3 * pixels)
            throw std::logic_error("every frame of a Y4M stream has the size that it was opened with");

        const std::string_view marker = "FRAME\n";
        buffer_.resize(marker.size() + 3 * pixels);
        uint8_t* const y = std::copy(marker.begin(), marker.end(), buffer_.data());
        for (std::size_t i = 0; i < pixels; ++i) {
            const YCbCr color = to_ycbcr(frame.rgb[3 * i], frame.rgb[3 * i + 1], frame.rgb[3 * i + 2]);
            y[i] = color.y;
            y[i + pixels] = color.cb;
            y[i + 2 * pixels] = color.cr;
        }
        stream_->write(buffer_);  // in one piece, so that a reader never waits for half a frame
    }

    void finish() override { stream_->commit(); }

private:
    std::unique_ptr<OutputStream> stream_;
    int width_, height_;
    std::vector<uint8_t> buffer_{};
};

}  // namespace

std::unique_ptr<FrameWriter> open_y4m_writer(const std::string& path, int width, int height, int fps) {
    return std::make_unique<Y4mWriter>(path, width, height, fps);
}

}  // namespace shade16::host
