// FrameWriter: takes finished frames, one after the other. The ending of the path picks the format.
#pragma once

#include <memory>
#include <string>

#include "host_sim/io/image.hpp"

namespace shade16::host {

class FrameWriter {
public:
    FrameWriter() = default;
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;
    virtual ~FrameWriter() = default;

    virtual void write(const Image& frame) = 0;

    /// The last frame is written. Without it a single output file does not appear.
    virtual void finish() = 0;
};

/// `.y4m` (also `-`, on standard output), `.apng` (one animated file), `.png` (name-0000.png and so on for several
/// frames), `.rgb565`, `.gray8`, `.gray4` and `.mono1` (raw).
std::unique_ptr<FrameWriter> open_writer(const std::string& path, int width, int height, int frame_count, int fps);

std::unique_ptr<FrameWriter> open_y4m_writer(const std::string& path, int width, int height, int fps);
std::unique_ptr<FrameWriter> open_png_writer(const std::string& path, int width, int height, int frame_count);
std::unique_ptr<FrameWriter> open_apng_writer(const std::string& path, int width, int height, int frame_count, int fps);
std::unique_ptr<FrameWriter> open_raw_writer(const std::string& path, int width, int height, int bits);

/// How many bits a pixel a raw file of that ending has; 0: it is none.
int raw_bits_of(const std::string& ending);

}  // namespace shade16::host
