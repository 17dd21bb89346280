// Displays that speak MIPI's Display Command Set over a serial bus: what all of their controllers have in common. A controller and its
// glass are data: a DcsPanel.
// Source: MIPI Alliance Specification for Display Command Set; the controllers' data sheets.
#pragma once

#include <display/command_list.hpp>
#include <display/wire.hpp>

namespace shade16 {

namespace dcs {
inline constexpr uint8_t no_operation = 0x00, reset = 0x01, sleep_out = 0x11, normal_mode = 0x13;
inline constexpr uint8_t not_inverted = 0x20, inverted = 0x21, display_off = 0x28, display_on = 0x29;
inline constexpr uint8_t columns = 0x2A, rows = 0x2B, write_memory = 0x2C, memory_access = 0x36, pixel_format = 0x3A;
inline constexpr uint8_t rows_mirrored = 0x80, columns_mirrored = 0x40, exchanged = 0x20, blue_first = 0x08;  // of memory_access
inline constexpr uint8_t sixteen_bits = 0x55;                                                                 // of pixel_format
}  // namespace dcs

/// How the picture stands: turned clockwise by quarters, and mirrored left to right before that.
struct Orientation {
    int quarter_turns = 0;
    bool mirrored = false;
    friend constexpr bool operator==(const Orientation&, const Orientation&) = default;
};

/// A controller and the glass in front of it. `first_column` and `first_row` say where the glass begins in the controller's memory;
/// `columns_mirrored` and `rows_mirrored`, which way memory runs behind an upright glass.
struct DcsPanel {
    const char* name = "";
    int width_px = 0, height_px = 0;
    int memory_width_px = 0, memory_height_px = 0;
    int first_column = 0, first_row = 0;
    bool columns_mirrored = false, rows_mirrored = false;
    bool blue_first = false;  // the order of the glass's subpixels
    bool inverted = false;    // IPS glass shows what is 0 as white unless told
    const uint8_t* beginning = nullptr;  // a list of command_list.hpp
    size_t beginning_bytes = 0;
};

namespace dcs {

/// The parameter of memory_access. A turned picture's columns are the controller's rows; which way each runs follows from the glass.
constexpr uint8_t access_of(const DcsPanel& panel, Orientation o) {
    const int turns = o.quarter_turns & 3;
    const bool turned = turns % 2 != 0;
    const bool column_flip = (turns == 1 || turns == 2) != (o.mirrored && !turned);
    const bool row_flip = (turns >= 2) != (o.mirrored && turned);
    unsigned bits = panel.blue_first ? blue_first : 0u;
    if (panel.columns_mirrored != column_flip) bits |= columns_mirrored;
    if (panel.rows_mirrored != row_flip) bits |= rows_mirrored;
    if (turned) bits |= exchanged;
    return static_cast<uint8_t>(bits);
}

/// Where the picture's first column and row lie, as the controller counts them: from the other end where it is mirrored.
struct Gap {
    int x = 0, y = 0;
};
constexpr Gap gap_of(const DcsPanel& panel, Orientation o) {
    const uint8_t access = access_of(panel, o);
    const int column = access & columns_mirrored ? panel.memory_width_px - panel.width_px - panel.first_column : panel.first_column;
    const int row = access & rows_mirrored ? panel.memory_height_px - panel.height_px - panel.first_row : panel.first_row;
    return access & exchanged ? Gap{row, column} : Gap{column, row};
}

}  // namespace dcs

/// What a four-wire bus does for a display. `Format` is how it wants pixels in memory: Rgb565 where it sends words of 16 bits,
/// Rgb565Swapped where it sends bytes. `pixels` may return before they are sent; all others wait for that.
template <class B>
concept DisplayBus = requires(B& bus, uint8_t byte, const uint8_t* bytes, const typename B::Format::Pixel* pixels, size_t count) {
    bus.reset();
    bus.command(byte);
    bus.data(bytes, count);
    bus.pixels(pixels, count);
    bus.wait();
    bus.delay_ms(uint32_t{5});
};

namespace dcs {

template <class Bus>
constexpr void send(Bus& bus, uint8_t command, uint8_t parameter) {
    bus.command(command);
    bus.data(&parameter, 1);
}

/// From reset to a display that is on.
template <DisplayBus Bus>
constexpr void begin(Bus& bus, const DcsPanel& panel, Orientation o) {
    bus.reset();
    run_commands(bus, panel.beginning, panel.beginning_bytes);
    send(bus, pixel_format, sixteen_bits);
    send(bus, memory_access, access_of(panel, o));
    bus.command(panel.inverted ? inverted : not_inverted);
    bus.command(normal_mode);
    bus.command(display_on);
}

/// The first and the last, the high byte before the low one.
template <DisplayBus Bus>
constexpr void send_range(Bus& bus, uint8_t command, int first, int count) {
    const int last = first + count - 1;
    const uint8_t ends[4] = {static_cast<uint8_t>(first >> 8), static_cast<uint8_t>(first), static_cast<uint8_t>(last >> 8),
                             static_cast<uint8_t>(last)};
    bus.command(command);
    bus.data(ends, 4);
}

/// The pixels that follow are those of an area of the picture.
template <DisplayBus Bus>
constexpr void select(Bus& bus, Gap gap, Area area) {
    send_range(bus, columns, area.x + gap.x, area.width);
    send_range(bus, rows, area.y + gap.y, area.height);
    bus.command(write_memory);
}

}  // namespace dcs

/// A sink for a display of the Display Command Set.
template <DisplayBus Bus, const DcsPanel& panel, Orientation orientation = Orientation{}>
class DcsDisplay {
    static constexpr bool turned = orientation.quarter_turns % 2 != 0;

public:
    using Pixel = typename Bus::Format;
    static constexpr int width_px = turned ? panel.height_px : panel.width_px, height_px = turned ? panel.width_px : panel.height_px;

    /// Eleven bytes of window before each band.
    static constexpr Wire wire(int bands) { return {static_cast<uint32_t>(8 * 11 * bands + 16 * width_px * height_px), Bus::bus_hz}; }

    constexpr explicit DcsDisplay(Bus bus = {}) : bus_(bus) { dcs::begin(bus_, panel, orientation); }

    constexpr void flush(Area area, const typename Pixel::Pixel* pixels, size_t bytes, bool) {
        constexpr dcs::Gap gap = dcs::gap_of(panel, orientation);
        dcs::select(bus_, gap, area);
        bus_.pixels(pixels, bytes / sizeof(*pixels));
    }
    constexpr void wait() { bus_.wait(); }

private:
    Bus bus_;
};

}  // namespace shade16
