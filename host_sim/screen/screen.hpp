// Something that shows frames: a panel, a kernel's framebuffer, a terminal.
#pragma once

#include <chrono>

#include "host_sim/engine/formats.hpp"
#include "host_sim/io/image.hpp"

namespace shade16::host {

/// What became of the frames so far.
struct ScreenFigures {
    uint64_t frames = 0, bytes = 0;  // of pixels, or of text, that were sent
    std::chrono::steady_clock::duration sending{};

    friend ScreenFigures operator+(const ScreenFigures& a, const ScreenFigures& b) {
        return {a.frames + b.frames, a.bytes + b.bytes, a.sending + b.sending};
    }
};

class Screen {
public:
    Screen() = default;
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    virtual ~Screen() = default;

    /// A terminal's may change from frame to frame.
    virtual Viewport size() const = 0;
    /// One of host_sim/engine/formats.hpp: that of the frames that it takes; nullptr if it takes any.
    virtual const char* format() const = 0;

    void show(const Image& frame) {
        const auto from = std::chrono::steady_clock::now();
        figures_.bytes += send(frame);
        ++figures_.frames;
        figures_.sending += std::chrono::steady_clock::now() - from;
    }
    const ScreenFigures& figures() const { return figures_; }
    /// Dark, where that is in its power.
    virtual void switch_off() {}

    /// The number of bytes that it took. For `show`, which counts.
    virtual std::size_t send(const Image& frame) = 0;

private:
    ScreenFigures figures_{};
};

}  // namespace shade16::host
