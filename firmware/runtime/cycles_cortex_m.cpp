// DWT's counter where there is one, else SysTick, which counts 24 bits down.
// Source: Armv7-M and Armv6-M Architecture Reference Manuals, Arm: C1.8 (DWT), B3.3 (SysTick).
#include <mcu/registers.hpp>
#include <runtime/cycles.hpp>

namespace shade16::cycles {

namespace {

constexpr uint32_t debug_control = 0xE000EDFC, trace_on = 1 << 24, dwt_control = 0xE0001000, dwt_cycles = 0xE0001004;
constexpr uint32_t tick_control = 0xE000E010, tick_reload = 0xE000E014, tick_value = 0xE000E018, tick_bits = 0xFFFFFF;
bool has_dwt = false;

#if defined(__ARM_ARCH_6M__)
bool begin_dwt() { return false; }
#else
bool begin_dwt() {
    set_bits<Registers>(debug_control, trace_on);
    set_bits<Registers>(dwt_control, 1);
    const uint32_t from = Registers::read(dwt_cycles);
    return Registers::read(dwt_cycles) != from;
}
#endif

}  // namespace

void begin() {
    has_dwt = begin_dwt();
    if (has_dwt) return;
    Registers::write(tick_reload, tick_bits);
    Registers::write(tick_value, 0);
    Registers::write(tick_control, 1 | 1 << 2);
}
uint32_t now() { return has_dwt ? Registers::read(dwt_cycles) : ~Registers::read(tick_value) & tick_bits; }
uint32_t between(uint32_t from, uint32_t to) { return has_dwt ? to - from : (to - from) & tick_bits; }
void spin(uint32_t turns) { asm volatile(".syntax unified\n1: subs %0, %0, #1\nbne 1b" : "+l"(turns) : : "cc"); }

}  // namespace shade16::cycles
