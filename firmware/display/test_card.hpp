// A picture that shows what is wrong with a display: docs/testcard.md. Colour bars (which byte, which subpixel, which sign), a grey ramp
// (lost bits), a border of one pixel and corners of four colours (offset, rotation, mirroring), a moving line (is it alive), and the
// settings in words.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

namespace detail {
/// Letters of 3x5 pixels, row by row, the top left one in bit 14: 0 to 9, A to Z.
inline constexpr uint16_t small_letters[36] = {
    0b111'101'101'101'111, 0b010'110'010'010'111, 0b111'001'111'100'111, 0b111'001'111'001'111, 0b101'101'111'001'001, 0b111'100'111'001'111,
    0b111'100'111'101'111, 0b111'001'001'001'001, 0b111'101'111'101'111, 0b111'101'111'001'111, 0b010'101'111'101'101, 0b110'101'110'101'110,
    0b011'100'100'100'011, 0b110'101'101'101'110, 0b111'100'110'100'111, 0b111'100'110'100'100, 0b011'100'101'101'011, 0b101'101'111'101'101,
    0b111'010'010'010'111, 0b001'001'001'101'010, 0b101'101'110'101'101, 0b100'100'100'100'111, 0b101'111'111'101'101, 0b110'101'101'101'101,
    0b010'101'101'101'010, 0b110'101'110'100'100, 0b010'101'101'110'011, 0b110'101'110'101'101, 0b011'100'010'001'110, 0b111'010'010'010'010,
    0b101'101'101'101'111, 0b101'101'101'101'010, 0b101'101'111'111'101, 0b101'101'010'101'101, 0b101'101'010'010'010, 0b111'001'010'100'111,
};
constexpr uint16_t small_letter(char c) {
    if (c >= '0' && c <= '9') return small_letters[c - '0'];
    if (c >= 'a' && c <= 'z') return small_letters[c - 'a' + 10];
    if (c >= 'A' && c <= 'Z') return small_letters[c - 'A' + 10];
    return c == '-' ? 0b000'000'111'000'000 : c == '_' ? 0b000'000'000'000'111 : c == '.' ? 0b000'000'000'000'010 : 0;
}
}  // namespace detail

/// The card of a screen of `width` x `height`; `words` are up to four lines.
struct TestCard {
    int width = 0, height = 0;
    const char* words[4]{};
    uint32_t frame = 0;  // which moves the line

    /// The colour of a pixel of the frame.
    constexpr Rgb color_at(int x, int y) const {
        const int shorter = min(width, height), corner = max(shorter / 6, min(16, shorter / 4));  // two lines of letters
        if (x == 0 || y == 0 || x == width - 1 || y == height - 1) return white;
        if (y < corner || y >= height - corner) {
            const bool left = x < corner, top = y < corner;
            if (left || x >= width - corner) return rgb(top ? (left ? 0xFF0000 : 0x00FF00) : (left ? 0x0000FF : 0xFFFF00));
            const int line = top ? y - 3 : y - (height - corner) - 3;
            return has_letter(x - corner - 3, line, top ? 0 : 2) ? white : black;
        }
        if (x == static_cast<int>(frame * 3 % static_cast<uint32_t>(width))) return rgb(0xFF00FF);
        if (y < height / 2) {
            constexpr uint32_t bars[8] = {0xFFFFFF, 0xFFFF00, 0x00FFFF, 0x00FF00, 0xFF00FF, 0xFF0000, 0x0000FF, 0x000000};
            return rgb(bars[x * 8 / width]);
        }
        const Unorm16 gray{static_cast<uint16_t>(x * 65535 / (width - 1))};
        return {gray, gray, gray};
    }

    template <PixelFormat Format>
    constexpr void draw(const Band<Format>& band) const {
        constexpr Channels channels = channels_of_format<Format>;
        const auto bits = detail::channel_bits<Format>();
        for (int y = band.first_row; y < band.first_row + band.rows; ++y) {
            Place<Format> place(band.row(y), 0, y);
            for (int x = 0; x < band.width; ++x, ++place) {
                const AccumulatorOf<channels> color = as_accumulator<channels>(color_at(x, y));
                ByChannel<channels, uint32_t> q24;
                for_each_channel<channels>([](uint32_t& code, uint32_t c, int b) { code = c * ((uint32_t{1} << b) - 1) + detail::q24_bias<Format>(); }, q24, color, bits);
                detail::put<Format>(place, q24);
            }
        }
    }

private:
    /// Two lines of letters that are four pixels apart, from (0, 0) on.
    constexpr bool has_letter(int x, int y, int first_line) const {
        if (x < 0 || y < 0 || y >= 14 || y % 7 >= 5 || x % 4 >= 3) return false;
        const char* text = words[first_line + y / 7];
        if (text == nullptr) return false;
        for (int skip = x / 4; skip > 0 && *text != 0; --skip) ++text;
        return *text != 0 && (detail::small_letter(*text) >> (14 - y % 7 * 3 - x % 4) & 1) != 0;
    }
};

}  // namespace shade16
