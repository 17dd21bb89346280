// The bus between a driver and a model: the bytes as a wire carries them.
#pragma once

#include "tests/displays/dcs_model.hpp"

namespace shade16::displays {

/// Sends bytes: pixels lie in memory as the display wants them.
struct ByteBus {
    using Format = Rgb565Swapped;
    DcsModel* model = nullptr;

    void reset() {
        model->reset_line(true), model->delay_ms(1), model->reset_line(false), model->delay_ms(1), model->reset_line(true);
        model->delay_ms(120);
    }
    void command(uint8_t byte) { model->command(byte); }
    void data(const uint8_t* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i) model->data(bytes[i]);
    }
    void pixels(const uint16_t* pixels, size_t count) { data(reinterpret_cast<const uint8_t*>(pixels), 2 * count); }
    void wait() {}
    void delay_ms(uint32_t ms) { model->delay_ms(ms); }
};

/// Sends words of 16 bits, the high byte first.
struct WordBus : ByteBus {
    using Format = Rgb565;
    void pixels(const uint16_t* pixels, size_t count) {
        for (size_t i = 0; i < count; ++i) model->data(static_cast<uint8_t>(pixels[i] >> 8)), model->data(static_cast<uint8_t>(pixels[i]));
    }
};

}  // namespace shade16::displays
