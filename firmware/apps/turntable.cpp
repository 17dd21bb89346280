// A placeholder that hashes a gradient: enough to compare a board with this computer.
#include <board.hpp>
#include <runtime/console.hpp>

int main() {
    using namespace shade16;
    for (uint32_t frame = 0; frame < 2; ++frame) {
        uint32_t hash = 2166136261u;
        for (uint32_t y = 0; y < static_cast<uint32_t>(Board::height_px); ++y) {
            for (uint32_t x = 0; x < static_cast<uint32_t>(Board::width_px); ++x) {
                hash = (hash ^ (x * y + frame)) * 16777619u;
            }
        }
        console::print("frame ");
        console::print_decimal(frame);
        console::print(" ");
        console::print_hex(hash);
        console::print("\n");
    }
    return 0;
}
