// The console of a board with a serial line: `Board::Uart` has begin(), send(byte), heard() (a byte, or -1) and wait(). A program that ends says so and rests.
#include <board.hpp>
#include <runtime/console.hpp>

namespace shade16::console {

using Uart = Board::Uart;

namespace {
void begin() {
    static bool has_begun = false;
    if (!has_begun) Uart::begin();
    has_begun = true;
}
}  // namespace

void print(const char* text) {
    begin();
    for (; *text != 0; ++text) Uart::send(static_cast<uint8_t>(*text));
}

/// What was sent to it before it was asked, if it hears.
bool is_told(const char* word) {
    begin();
    static char words[33];  // as much as a chip keeps
    for (char* next = words; next != words + 32; ++next) {
        const int byte = Uart::heard();
        if (byte < 0) break;
        *next = static_cast<char>(byte);
    }
    const char* at = words;
    while (*word != 0 && *at == *word) ++at, ++word;
    return *word == 0 && *at == 0;
}

void exit(int status) {
    print("exit ");
    print_decimal(static_cast<uint32_t>(status));
    print("\n");
    Uart::wait();
    for (;;) asm volatile("wfi");
}

}  // namespace shade16::console
