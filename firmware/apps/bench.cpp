// How many cycles a frame of the turntable takes on this very chip, by stage, as a table to paste. Each stage alone first, the bus with
// nothing drawn meanwhile; then a frame as present() makes it, where one band is sent while the next is drawn.
#include <apps/turntable_scene.hpp>
#include <display/wire.hpp>
#include <runtime/console.hpp>
#include <runtime/cycles.hpp>

using namespace shade16;
using console::print, console::print_decimal;

namespace {

struct NoPanel {
    void flush(Area, const Board::Pixel::Pixel*, size_t, bool) {}
    void wait() {}
};
/// The board's panel without the hash of what it shows.
template <class B>
auto panel_of() {
#ifndef SHADE16_NO_PANEL
    if constexpr (requires { typename B::Panel; }) return typename B::Panel{};
    else
#endif
        return NoPanel{};
}

TurntableWorkspace workspace;
BoardBuffer buffers[Board::bands];
constexpr uint32_t frames = 8;       // once around
constexpr uint32_t turns = 100'000;  // of a loop of two instructions

template <class Action>
uint32_t cycles_of(Action action) {
    const uint32_t from = cycles::now();
    action();
    return cycles::between(from, cycles::now());
}

/// By subtraction: an image has no divider that its processor lacks.
uint32_t quotient(uint64_t n, uint32_t d) {
    uint32_t q = 0;
    for (int bit = 31; bit >= 0; --bit)
        if (n >= uint64_t{d} << bit) n -= uint64_t{d} << bit, q |= uint32_t{1} << bit;
    return q;
}

void print_row(const char* stage, uint64_t cycles_of_frames) {
    const uint32_t a_frame = quotient(cycles_of_frames, frames), tens_us = quotient(a_frame, Board::cpu_hz / 100'000);
    const uint32_t ms = quotient(tens_us, 100), rest = tens_us - 100 * ms;
    print("| "), print(stage), print(" | "), print_decimal(a_frame), print(" | ");
    print_decimal(ms), print(rest < 10 ? ".0" : "."), print_decimal(rest), print(" |\n");
}

template <class Action>
void for_each_band(Action action) {
    for (int y = 0; y < Board::height_px; y += Board::band_rows) action(buffers[0].band(y, min(Board::band_rows, Board::height_px - y)));
}

template <class Panel>
uint32_t send_blank(Panel& panel) {
    uint32_t sum = 0;
    for_each_band([&](const Band<Board::Pixel>& band) {
        sum += cycles_of([&] {
            panel.flush({0, band.first_row, band.width, band.rows}, band.pixels, band.pixel_bytes(), band.first_row + band.rows >= Board::height_px);
            panel.wait();
        });
    });
    return sum;
}

template <class B>
void print_wire() {
    if constexpr (requires { typename B::Panel; }) {
        if constexpr (HasWire<typename B::Panel>) {
            constexpr Wire wire = B::Panel::wire(bands_of(B::height_px, B::band_rows));
            print("The bus: "), print_decimal(wire.bits_a_frame), print(" bits a frame at "), print_decimal(wire.hz), print(" Hz\n");
        }
    }
}

}  // namespace

int main() {
    auto panel = panel_of<Board>();
    TurntableRenderer renderer(workspace);
    cycles::begin();
    const uint32_t yardstick = cycles_of([] { cycles::spin(turns); });
    uint64_t vertices = 0, clearing = 0, drawing = 0, bus = 0, all = 0;
    for (uint32_t stop = 0; stop < frames; ++stop) {
        const Pose pose = turntable_pose(stop);
        const Frame frame{.poses = &pose};
        vertices += cycles_of([&] { renderer.begin(frame, screen); });
        for_each_band([&](const Band<Board::Pixel>& band) {
            clearing += cycles_of([&] { clear_to(band, Board::background); });
            drawing += cycles_of([&] { renderer.draw(band); });
        });
        bus += send_blank(panel);
        all += cycles_of([&] { present(renderer, frame, screen, buffers, panel); });
    }
    print(Board::name), print(", "), print_decimal(Board::width_px), print("x"), print_decimal(Board::height_px), print("\n\n");
    print("| stage | cycles a frame | ms |\n|---|---|---|\n");
    print_row(Board::vertex_store == VertexStore::keep ? "vertices: transform and light" : "set-up of the frame", vertices);
    print_row("background", clearing);
    print_row(Board::vertex_store == VertexStore::keep ? "triangles" : "triangles and their vertices", drawing - clearing);
    print_row("the bus alone", bus);
    print_row("a frame", all);
    print("\nThe yardstick: "), print_decimal(turns), print(" turns of a loop of two instructions in "), print_decimal(yardstick), print(" cycles\n");
    print_wire<Board>();
    return 0;
}
