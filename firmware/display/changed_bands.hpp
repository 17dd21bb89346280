// Dirty rows: a sink that passes on only the bands that changed since they were last sent, for panels that keep what they show.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

/// What a band holds, in 64 bits: nothing at first. Each pixel goes into both halves by a step that can be undone, so that bands which differ in
/// one pixel never have the same mark; others have it by chance, once in 2^64.
struct BandMark {
    uint32_t low = 0, high = 0;

    template <class Pixel>
    static constexpr BandMark of(const Pixel* pixels, size_t bytes) {
        BandMark mark{static_cast<uint32_t>(bytes), 1};
        const size_t count = bytes / sizeof(Pixel);
        for (size_t i = 0; i < count; ++i) mark.add(pixels[i]);
        mark.high |= 1;  // never nothing
        return mark;
    }
    friend constexpr bool operator==(const BandMark&, const BandMark&) = default;

private:
    constexpr void add(uint32_t word) {
        low = (low ^ word) * 0x9E3779B1;
        high = ((high << 7 | high >> 25) ^ word) * 0x85EBCA77;
    }
};

/// `Panel` gets a band of `BandRows` rows when its mark is another than when it was last sent. A frame whose last band is not sent has no `last`,
/// which panels do without. Any other area is passed on, and what it touches is sent again.
/// Cost   8 bytes a band, and 7 instructions a pixel on a Cortex-M4; a pixel takes a bus of 20 MHz 800 ns.
template <class Panel, int BandRows>
class ChangedBands {
public:
    using Pixel = typename Panel::Pixel;
    static constexpr int width_px = Panel::width_px, height_px = Panel::height_px;

    constexpr ChangedBands() = default;
    constexpr explicit ChangedBands(const Panel& panel) : panel_(panel) {}

    template <class Memory>
    constexpr void flush(Area area, const Memory* pixels, size_t bytes, bool last) {
        const bool is_band = area.x == 0 && area.width == width_px && area.y % BandRows == 0 && area.height <= BandRows;
        const BandMark mark = is_band ? BandMark::of(pixels, bytes) : BandMark{};
        if (is_band && mark == marks_[area.y / BandRows]) return;
        for (int32_t y = area.y; y < area.y + area.height; ++y) marks_[y / BandRows] = {};
        if (is_band) marks_[area.y / BandRows] = mark;
        panel_.flush(area, pixels, bytes, last);
    }
    constexpr void wait() { panel_.wait(); }
    /// Everything is sent again: after the panel was off, or something else drew on it.
    constexpr void forget() {
        for (BandMark& mark : marks_) mark = {};
    }

private:
    Panel panel_{};
    BandMark marks_[static_cast<size_t>((height_px + BandRows - 1) / BandRows)]{};
};

}  // namespace shade16
