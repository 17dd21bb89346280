// Where the stubs of foreign libraries put pixels: as RGB565 codes, with what is still on its way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stub {

struct Screen {
    int width = 48, height = 32;
    std::vector<uint16_t> codes = std::vector<uint16_t>(48 * 32);
    bool wrong = false;  // a call that the library does not allow

    /// Pixels whose bytes come as in memory, the high one first.
    void put(int x, int y, int w, int h, const void* pixels) {
        if (x < 0 || y < 0 || x + w > width || y + h > height) {
            wrong = true;
            return;
        }
        const auto* byte = static_cast<const uint8_t*>(pixels);
        for (int row = y; row < y + h; ++row)
            for (int column = x; column < x + w; ++column, byte += 2)
                codes[static_cast<std::size_t>(row * width + column)] = static_cast<uint16_t>(byte[0] << 8 | byte[1]);
    }
};

/// DMA: the pixels are read only when somebody waits, and until then must not change.
struct Dma {
    Screen* screen = nullptr;
    int x = 0, y = 0, w = 0, h = 0;
    const void* pixels = nullptr;

    void start(int x0, int y0, int width, int height, const void* p) {
        if (pixels != nullptr) screen->wrong = true;
        x = x0, y = y0, w = width, h = height, pixels = p;
    }
    void wait() {
        if (pixels != nullptr) screen->put(x, y, w, h, pixels);
        pixels = nullptr;
    }
};

}  // namespace stub
