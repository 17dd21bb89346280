// The test card of docs/testcard.md on the board's display, with its line at two places.
#include <board.hpp>
#include <display/test_card.hpp>

using namespace shade16;

/// "320x240", without a library.
struct SizeText {
    char text[12]{};
    constexpr SizeText(int width, int height) {
        char* at = append(text, width);
        *at++ = 'x';
        append(at, height);
    }

private:
    static constexpr char* append(char* at, int number) {
        int power = 1;
        while (number / power >= 10) power *= 10;
        for (; power != 0; power /= 10) *at++ = static_cast<char>('0' + number / power % 10);
        return at;
    }
};
static constexpr SizeText size(Board::width_px, Board::height_px);

template <PixelFormat Format>
constexpr const char* name_of() {
    if constexpr (DitheredFormat<Format>) return Format::Undithered::name;
    else return Format::name;
}

static Board board;
static BandBuffer<Board::Pixel, Board::width_px, Board::band_rows, false> buffer;

int main() {
    for (uint32_t frame = 0; frame < 2; ++frame) {
        const TestCard card{Board::width_px, Board::height_px, {size.text, name_of<Board::Pixel>()}, 10 * frame};
        for (int y = 0; y < Board::height_px; y += Board::band_rows) {
            const auto band = buffer.band(y, min(Board::band_rows, Board::height_px - y));
            board.display.wait();
            card.draw(band);
            board.display.flush({0, y, band.width, band.rows}, band.pixels, band.pixel_bytes(), y + band.rows >= Board::height_px);
        }
    }
    board.display.wait();
    return 0;
}
