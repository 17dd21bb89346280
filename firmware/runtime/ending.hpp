// How a program ends on a board: what a start-up does with the status of main(), and with a fault of the processor.
#pragma once

#include <stdint.h>

namespace shade16 {

/// Says what went wrong if something did; told "stack", also how much of the stack was used.
[[noreturn]] void end_program(int status);

/// One sentence and status 1. `number` is the processor's own for what happened, `stack` its stack pointer then. The stack may be what
/// broke, so that a start-up calls this with a fresh one.
[[noreturn]] void end_by_fault(uint32_t address, uint32_t number, const uint32_t* stack);

}  // namespace shade16
