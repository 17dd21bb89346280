// From reset to main() on any Cortex-M, and one sentence when the processor faults.
#include <runtime/ending.hpp>
#include <runtime/variables.hpp>

int main();

namespace {

using namespace shade16;

void enable_fpu() {
#if defined(__ARM_FP)
    auto& coprocessor_access = *reinterpret_cast<volatile uint32_t*>(0xE000ED88);
    coprocessor_access = coprocessor_access | (uint32_t{0xF} << 20);
    asm volatile("dsb\nisb");
#endif
}

}  // namespace

extern "C" {

[[noreturn]] __attribute__((used)) void shade16_reset() {
    enable_fpu();
    initialise_variables();
    end_program(main());
}

[[noreturn]] __attribute__((used)) void shade16_report_fault(uint32_t address, uint32_t exception, const uint32_t* stack) {
    end_by_fault(address, exception, stack);
}

// What the processor saved on its way into the exception is r0 r1 r2 r3 r12 lr pc psr, unless the stack is what broke.
[[noreturn]] __attribute__((naked, used)) void shade16_fault() {
    asm("mrs r2, msp\n"
        "mrs r1, ipsr\n"
        "movs r0, #0\n"
        "ldr r3, =shade16_bss_end\n"
        "cmp r2, r3\n"
        "blo 1f\n"
        "ldr r0, [r2, #24]\n"
        "1: ldr r3, =shade16_stack_end\n"
        "mov sp, r3\n"
        "bl shade16_report_fault\n"
        ".ltorg\n");
}

// The 16 system exceptions. Nothing here enables an interrupt; a board that does brings a longer table.
__attribute__((section(".vectors"), used)) const uintptr_t shade16_vectors[16] = {
    reinterpret_cast<uintptr_t>(shade16_stack_end),
    reinterpret_cast<uintptr_t>(shade16_reset),
    reinterpret_cast<uintptr_t>(shade16_fault),  // NMI
    reinterpret_cast<uintptr_t>(shade16_fault),  // hard fault
    reinterpret_cast<uintptr_t>(shade16_fault),  // memory management
    reinterpret_cast<uintptr_t>(shade16_fault),  // bus
    reinterpret_cast<uintptr_t>(shade16_fault),  // usage
    0,
    0,
    0,
    0,
    reinterpret_cast<uintptr_t>(shade16_fault),  // supervisor call
    0,
    0,
    reinterpret_cast<uintptr_t>(shade16_fault),  // pended supervisor call
    reinterpret_cast<uintptr_t>(shade16_fault),  // SysTick
};
}
