// Raw: the target's own pixels, frame after frame, nothing else: what would go over the display's bus. Rows of pixels that
// share bytes begin on a byte.
#include <filesystem>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/frame_writer.hpp"

namespace shade16::host {

namespace {

class RawWriter final : public FrameWriter {
public:
    RawWriter(const std::string& path, int width, int height, int bits)
        : stream_(open_output(path)),
          path_(path),
          frame_bytes_((static_cast<std::size_t>(width) * static_cast<std::size_t>(bits) + 7) / 8 *
                       static_cast<std::size_t>(height)),
          bits_(bits) {}

    void write(const Image& frame) override {
        if (frame.raw.size() != frame_bytes_)
            throw input_error(
                "{}: {} holds {} bytes a frame, but this target's frame has {}; expected a {}-bit pixel format.", path_,
                std::filesystem::path(path_).extension().string(), frame_bytes_, frame.raw.size(), bits_);
        stream_->write(frame.raw);
    }

    void finish() override { stream_->commit(); }

private:
    std::unique_ptr<OutputStream> stream_;
    std::string path_;
    std::size_t frame_bytes_;
    int bits_;
};

}  // namespace

std::unique_ptr<FrameWriter> open_raw_writer(const std::string& path, int width, int height, int bits) {
    return std::make_unique<RawWriter>(path, width, height, bits);
}

}  // namespace shade16::host
