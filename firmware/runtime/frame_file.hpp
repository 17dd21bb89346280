// Frames as PPM pictures in the folder that SHADE16_FRAMES names, 0.ppm and on. On this computer only, for
// tests/golden.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <shade16/shade16.hpp>
#include <string>

namespace shade16 {

class FrameFile {
public:
    template <PixelFormat Format>
    void add(Area area, const typename Format::Pixel* pixels, bool last) {
        const char* const folder = std::getenv("SHADE16_FRAMES");
        if (folder == nullptr) return;
        for (int32_t y = 0; y < area.height; ++y)
            for (int32_t x = 0; x < area.width; ++x) append<Format>(pixels + y * pixels_a_row<Format>(area.width), x);
        if (!last) return;
        const std::string path = std::string(folder) + "/" + std::to_string(frame_++) + ".ppm";
        const std::string head =
            "P6 " + std::to_string(area.width) + " " + std::to_string(area.y + area.height) + " 255\n";
        write(path, head + rgb_);
        rgb_.clear();
    }

private:
    template <PixelFormat Format>
    void append(const typename Format::Pixel* row, int32_t x) {
        if constexpr (GrayFormat<Format>) {
            const uint8_t gray = widened(static_cast<int>(luma_code<Format>(row, x)), (1 << Format::luma_bits) - 1);
            append(Rgb888::Pixel{gray, gray, gray});
        } else if constexpr (requires { Format::from_rgb565(row[x]); }) {
            append(Format::from_rgb565(row[x]));  // which exchanges the bytes back where the display wants them exchanged
        } else {
            append(row[x]);
        }
    }
    void append(Rgb888::Pixel p) { rgb_ += {static_cast<char>(p.r), static_cast<char>(p.g), static_cast<char>(p.b)}; }
    void append(uint16_t p) {
        append(Rgb888::Pixel{widened(p >> 11, 31), widened(p >> 5 & 63, 63), widened(p & 31, 31)});
    }
    static uint8_t widened(int code, int max_code) {
        return static_cast<uint8_t>((code * 255 + max_code / 2) / max_code);
    }

    static void write(const std::string& path, const std::string& bytes) {
        std::FILE* const file = std::fopen(path.c_str(), "wb");
        const bool written = file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
        if (file == nullptr || std::fclose(file) != 0 || !written) {
            std::fprintf(stderr, "%s: cannot be written.\n", path.c_str());
            std::exit(3);
        }
    }

    std::string rgb_{};
    int frame_ = 0;
};

}  // namespace shade16
