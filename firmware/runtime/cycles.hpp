// The processor's own clock: how long something took.
#pragma once

#include <stdint.h>

namespace shade16::cycles {

void begin();
uint32_t now();
/// From one `now` to another. 24 bits on a Cortex-M without a cycle counter: a tenth of a second at 168 MHz.
uint32_t between(uint32_t from, uint32_t to);

/// A yardstick: two instructions a turn, and nothing from memory but them.
void spin(uint32_t turns);

}  // namespace shade16::cycles
