// The processor has no counter; the board has one of 24 MHz.
// Source: Versatile Application Baseboard for ARM926EJ-S User Guide, Arm: SYS_24MHZ.
#include <mcu/registers.hpp>
#include <runtime/cycles.hpp>

namespace shade16::cycles {

void begin() {}
uint32_t now() { return Registers::read(0x1000005C); }
uint32_t between(uint32_t from, uint32_t to) { return to - from; }
void spin(uint32_t turns) { asm volatile("1: subs %0, %0, #1\nbne 1b" : "+r"(turns) : : "cc"); }

}  // namespace shade16::cycles
