// The console of a board with a serial line: `Board::Uart` has begin(), send(byte) and wait(). A program that ends says so and rests.
#include <board.hpp>
#include <runtime/console.hpp>

namespace shade16::console {

using Uart = Board::Uart;

void print(const char* text) {
    static bool has_begun = false;
    if (!has_begun) Uart::begin();
    has_begun = true;
    for (; *text != 0; ++text) Uart::send(static_cast<uint8_t>(*text));
}

void exit(int status) {
    print("exit ");
    print_decimal(static_cast<uint32_t>(status));
    print("\n");
    Uart::wait();
    for (;;) asm volatile("wfi");
}

}  // namespace shade16::console
