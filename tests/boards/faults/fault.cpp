// Goes wrong in one way, which the build names: how a board's program ends is then for fault.cmake to judge.
#include <mcu/registers.hpp>
#include <runtime/console.hpp>
#include <runtime/stack.hpp>

using namespace shade16;

namespace {

/// Where no board has memory.
[[maybe_unused]] int read_nothing() { return static_cast<int>(Registers::read(0x90000000)); }

[[maybe_unused]] int run_nonsense() {
#if defined(__xtensa__)
    asm volatile("ill");
#elif defined(__riscv)
    asm volatile("unimp");
#else
    asm volatile("udf #0");
#endif
    return 0;
}

volatile uint32_t depth;

/// Goes down to `end` and returns, or for ever.
[[gnu::noinline]] [[maybe_unused]] uint32_t descend(const uint32_t* end) {
    volatile uint32_t words[8];
    for (volatile uint32_t& word : words) word = depth;
    depth = depth + 1;
    if (const_cast<const uint32_t*>(words) < end) return words[0];
    return descend(end) + words[depth & 7];
}

/// Comes back, so that only the stack's own paint tells.
[[maybe_unused]] int leave_stack() {
    descend(shade16_bss_end);
    return 0;
}

/// Does not come back.
[[maybe_unused]] int leave_memory() { return static_cast<int>(descend(nullptr)); }

/// For hardware that does not answer.
[[maybe_unused]] int wait_for_nobody() {
    static volatile uint32_t status = 0;
    if (!wait_for<Registers>(static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&status)), 1, 1)) console::fail("Nobody answers.");
    return 0;
}

[[maybe_unused]] int fail_quietly() { return 3; }

}  // namespace

int main() { return SHADE16_FAULT(); }
