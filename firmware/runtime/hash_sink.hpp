// A display made of arithmetic: it prints a hash of every frame, so that two machines can compare what they draw.
#pragma once

#include <runtime/console.hpp>
#include <runtime/fnv1a.hpp>
#include <shade16/shade16.hpp>
#ifdef SHADE16_FRAME_FILES
#include <runtime/frame_file.hpp>
#endif

namespace shade16 {

/// A hash over the pixels' bytes, in the order a display would take them.
template <PixelFormat Format>
class HashSinkOf {
public:
    void flush([[maybe_unused]] Area area, const typename Format::Pixel* pixels, size_t bytes, bool last) {
        const auto* byte = reinterpret_cast<const unsigned char*>(pixels);
        for (size_t i = 0; i < bytes; ++i) hash_.add(byte[i]);
#ifdef SHADE16_FRAME_FILES
        file_.template add<Format>(area, pixels, last);
#endif
        if (last) end_frame();
    }
    void wait() {}

private:
    void end_frame() {
        console::print("frame ");
        console::print_decimal(frame_++);
        console::print(" ");
        console::print_hex(hash_.value);
        console::print("\n");
        hash_ = {};
    }

    Fnv1a hash_{};
    uint32_t frame_ = 0;
#ifdef SHADE16_FRAME_FILES
    FrameFile file_{};
#endif
};
using HashSink = HashSinkOf<Rgb565>;

}  // namespace shade16
