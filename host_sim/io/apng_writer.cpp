// APNG: a film that web pages and documents show like a picture. Each frame is a PNG of libpng's, taken apart.
#include <stdexcept>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/changed_part.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "host_sim/io/png_chunk.hpp"

namespace shade16::host {

namespace {

class ApngWriter final : public FrameWriter {
public:
    ApngWriter(const std::string& path, int width, int height, int frame_count, int fps)
        : stream_(open_output(path)), path_(path), width_(width), height_(height), left_(frame_count), fps_(fps) {}

    void write(const Image& frame) override {
        const std::size_t bytes = 3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        if (frame.width != width_ || frame.height != height_ || frame.rgb.size() != bytes || left_ == 0)
            throw std::logic_error(
                "every frame of an APNG has the size, and is one of the frames, that it was opened with");
        const ChangedPart part = changed_part(frame, before_);
        const std::vector<uint8_t> png = encoded_png(part.pixels, path_);
        if (before_.rgb.empty()) write_head(png);
        write_control(part);
        write_pixels(png_contents(png, "IDAT"));
        before_ = frame;
        --left_;
    }

    void finish() override {
        stream_->write(png_chunk("IEND", {}));
        stream_->commit();
    }

private:
    /// Readers must know the number of frames beforehand. The first frame is also what others show as the picture.
    void write_head(const std::vector<uint8_t>& png) {
        stream_->write(png_signature);
        stream_->write(png_chunk("IHDR", png_contents(png, "IHDR")));
        std::vector<uint8_t> animation;
        append_big_endian(animation, static_cast<uint32_t>(left_), 4);
        append_big_endian(animation, 0, 4);  // plays for ever
        stream_->write(png_chunk("acTL", animation));
    }

    void write_control(const ChangedPart& part) {
        std::vector<uint8_t> control;
        append_big_endian(control, sequence_++, 4);
        for (const int number : {part.pixels.width, part.pixels.height, part.x, part.y})
            append_big_endian(control, static_cast<uint32_t>(number), 4);
        append_big_endian(control, 1, 2);
        append_big_endian(control, static_cast<uint32_t>(fps_), 2);
        append_big_endian(control, 0, 2);  // leave the canvas as it is afterwards; replace what was there
        stream_->write(png_chunk("fcTL", control));
    }

    void write_pixels(const std::vector<uint8_t>& compressed) {
        if (before_.rgb.empty()) return stream_->write(png_chunk("IDAT", compressed));
        std::vector<uint8_t> data;
        append_big_endian(data, sequence_++, 4);
        data.insert(data.end(), compressed.begin(), compressed.end());
        stream_->write(png_chunk("fdAT", data));
    }

    std::unique_ptr<OutputStream> stream_;
    std::string path_;
    int width_, height_, left_, fps_;
    uint32_t sequence_ = 0;
    Image before_{};
};

}  // namespace

std::unique_ptr<FrameWriter> open_apng_writer(const std::string& path, int width, int height, int frame_count,
                                              int fps) {
    return std::make_unique<ApngWriter>(path, width, height, frame_count, fps);
}

}  // namespace shade16::host
