// Sink: whatever takes finished bands. A display driver, a file, a window.
#pragma once

#include "shade16/target/band.hpp"

namespace shade16 {

struct Area {
    int32_t x = 0, y = 0, width = 0, height = 0;
};

/// flush hands a band over and may return before it is sent: the sink owns the pixels until wait returns. The engine
/// draws the other band meanwhile. `last` marks the end of a frame.
template <class S, class Format>
concept Sink = requires(S& sink, Area area, const typename Format::Pixel* pixels, size_t bytes, bool last) {
    sink.flush(area, pixels, bytes, last);
    sink.wait();
};

}  // namespace shade16
