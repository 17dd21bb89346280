// The console of an RP2040 is its UART 0, 115200 baud: it speaks on line 0 and hears on line 1. A program that ends says so and rests.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 4.2 (UART).
#include <mcu/rp2040/chip.hpp>
#include <runtime/console.hpp>

namespace shade16::console {

namespace {

constexpr uint32_t uart = 0x40034000, data = uart, flags = uart + 0x18, full = 1 << 5, empty = 1 << 4, busy = 1 << 3;

void begin() {
    static bool has_begun = false;
    if (has_begun) return;
    has_begun = true;
    rp2040::wake(rp2040::part::io_bank | rp2040::part::pads | rp2040::part::uart0);  // also where the clocks failed
    rp2040::assign(0, rp2040::Function::uart), rp2040::assign(1, rp2040::Function::uart);
    Registers::write(uart + 0x24, 67), Registers::write(uart + 0x28, 52);  // 125 MHz / 16 / 67.8
    Registers::write(uart + 0x2C, 0x70), Registers::write(uart + 0x30, 0x301);
}

}  // namespace

void print(const char* text) {
    begin();
    for (; *text != 0; ++text)
        if (wait_for<Registers>(flags, full, 0)) Registers::write(data, static_cast<uint8_t>(*text));
}

/// What was sent to it and nobody has read.
bool is_told(const char* word) {
    begin();
    static char heard[33];  // as much as the chip keeps
    for (char* next = heard; next != heard + 32 && (Registers::read(uart + 0x18) & empty) == 0; ++next)
        *next = static_cast<char>(Registers::read(data));
    const char* at = heard;
    while (*word != 0 && *at == *word) ++at, ++word;
    return *word == 0 && *at == 0;
}

void exit(int status) {
    print("exit ");
    print_decimal(static_cast<uint32_t>(status));
    print("\n");
    static_cast<void>(wait_for<Registers>(flags, busy, 0));
    for (;;) asm volatile("wfi");
}

}  // namespace shade16::console
