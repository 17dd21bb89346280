// The display of an emulated board: every band is hashed, so that two machines can compare what they draw, and shown on the panel that
// the board has. `Format` is the panel's own, or that dithered. A computer that runs the board's app has no such panel, and neither have some
// emulators.
#pragma once

#include <runtime/hash_sink.hpp>

namespace shade16 {

#ifdef SHADE16_NO_PANEL
template <class Panel, class Format = typename Panel::Pixel>
using SeenOn = HashSinkOf<Format>;
#else
template <class Panel, class Format = typename Panel::Pixel>
class SeenOn {
public:
    void flush(Area area, const typename Format::Pixel* pixels, size_t bytes, bool last) {
        panel_.flush(area, pixels, bytes, last);
        hash_.flush(area, pixels, bytes, last);
    }
    void wait() { panel_.wait(); }

private:
    Panel panel_{};
    HashSinkOf<Format> hash_{};
};
#endif

}  // namespace shade16
