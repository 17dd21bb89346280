// Boot stage 2: the first 256 bytes of the flash, which the RP2040's ROM copies to RAM and runs if their last four are the CRC of the
// others. It lets the flash be read as memory, by the command that every flash knows, and goes on at the vectors behind it. And the
// clocks, which run before anything else of the program does.
// Source: RP2040 Datasheet, Raspberry Pi Ltd: 2.8.1.3.1 (its checksum), 4.10 (SSI).
#include <stddef.h>

#include <mcu/rp2040/chip.hpp>

namespace shade16::rp2040 {

namespace {

struct BootStage {
    uint8_t bytes[256]{};
};

/// Polynomial 0x04C11DB7, the highest bit first, from all ones; nothing is inverted.
constexpr uint32_t crc32(const uint8_t* bytes, size_t count) {
    uint32_t crc = 0xFFFFFFFF;
    for (size_t i = 0; i < count; ++i) {
        crc ^= uint32_t{bytes[i]} << 24;
        for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ (crc >> 31 != 0 ? 0x04C11DB7 : 0);
    }
    return crc;
}

constexpr uint16_t code[] = {
    0xB500,                  // push {lr}: 0 where the ROM starts the chip
    0x4B0D,                  // ldr r3, SSI
    0x2100, 0x6099,          // off
    0x2104, 0x6159,          // a quarter of the system's clock
    0x490B, 0x6019,          // 32 bits a word, a command and then what is read
    0x490B, 0x480C, 0x18C0,  // the flash's command: read, 24 bits of address
    0x6001,                  //
    0x2100, 0x6059,          // one word at a time
    0x2101, 0x6099,          // on
    0xBC01, 0x2800, 0xD000,  // pop {r0}; back to who called, if somebody did
    0x4700,                  // bx r0
    0x4807, 0x4908, 0x6008,  // else the vectors are
    0xC803,                  // behind this: the stack and where to begin
    0xF380, 0x8808,          // msr msp, r0
    0x4708,                  // bx r1
    0x46C0,                  // nop
    0x0000, 0x1800,          // SSI
    0x0300, 0x001F,          // its control
    0x0218, 0x0300,          // the flash's command, 0x03
    0x00F4, 0x0000,          // where that is said
    0x0100, 0x1000,          // the vectors
    0xED08, 0xE000,          // which the processor looks up here
};

constexpr BootStage boot_stage = [] {
    BootStage stage;
    for (size_t i = 0; i < sizeof(code) / 2; ++i) stage.bytes[2 * i] = static_cast<uint8_t>(code[i]), stage.bytes[2 * i + 1] = static_cast<uint8_t>(code[i] >> 8);
    const uint32_t crc = crc32(stage.bytes, 252);
    for (size_t i = 0; i < 4; ++i) stage.bytes[252 + i] = static_cast<uint8_t>(crc >> (8 * i));
    return stage;
}();

}  // namespace

extern "C" __attribute__((section(".boot2"), used)) const BootStage shade16_boot_stage = boot_stage;

/// Constructors with a priority run first, and the display's and the console's clocks follow from these.
__attribute__((constructor(101))) static void begin() { begin_clocks(); }

}  // namespace shade16::rp2040
