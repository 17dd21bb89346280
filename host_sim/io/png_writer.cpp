// PNG: one file a frame, numbered when there are several.
#include <filesystem>
#include <stdexcept>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "host_sim/io/png_chunk.hpp"

namespace shade16::host {

namespace {

class PngWriter final : public FrameWriter {
public:
    PngWriter(std::string path, int width, int height, int frame_count)
        : path_(std::move(path)), width_(width), height_(height), numbered_(frame_count > 1) {}

    void write(const Image& frame) override {
        const std::size_t bytes = 3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        if (frame.width != width_ || frame.height != height_ || frame.rgb.size() != bytes)
            throw std::logic_error("every frame of a PNG sequence has the size that it was opened with");
        const std::string path = numbered_ ? numbered_path(next_++) : path_;
        const auto stream = open_output(path);
        stream->write(encoded_png(frame, path));
        stream->commit();
    }

    void finish() override {}

private:
    std::string numbered_path(int number) const {
        const std::filesystem::path path(path_);
        return (path.parent_path() / fmt::format("{}-{:04}.png", path.stem().string(), number)).string();
    }

    std::string path_;
    int width_, height_;
    bool numbered_;
    int next_ = 0;
};

}  // namespace

std::unique_ptr<FrameWriter> open_png_writer(const std::string& path, int width, int height, int frame_count) {
    return std::make_unique<PngWriter>(path, width, height, frame_count);
}

}  // namespace shade16::host
