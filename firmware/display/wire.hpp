// What a panel's bus carries.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

/// Bits on the wire, commands and what a protocol adds included.
struct Wire {
    uint32_t bits_a_frame = 0, hz = 0;
};

constexpr int bands_of(int height, int band_rows) { return (height + band_rows - 1) / band_rows; }

/// A panel on a serial bus says what `bands` of a frame are on it.
template <class Panel>
concept HasWire = requires(int bands) { Panel::wire(bands); };

}  // namespace shade16
