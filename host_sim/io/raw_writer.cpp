// Raw: the target's own 16-bit pixels, frame after frame, nothing else: what would go over the display's bus.
#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/frame_writer.hpp"

namespace shade16::host {

namespace {

class RawWriter final : public FrameWriter {
public:
    RawWriter(const std::string& path, int width, int height)
        : stream_(open_output(path)),
          path_(path),
          frame_bytes_(2 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    void write(const Image& frame) override {
        if (frame.raw.size() != frame_bytes_)
            throw input_error(
                "{}: .rgb565 holds {} bytes a frame, but this target's frame has {}; expected a 16-bit pixel format.",
                path_, frame_bytes_, frame.raw.size());
        stream_->write(frame.raw);
    }

    void finish() override { stream_->commit(); }

private:
    std::unique_ptr<OutputStream> stream_;
    std::string path_;
    std::size_t frame_bytes_;
};

}  // namespace

std::unique_ptr<FrameWriter> open_raw_writer(const std::string& path, int width, int height) {
    return std::make_unique<RawWriter>(path, width, height);
}

}  // namespace shade16::host
