// Lists of commands as bytes: a command, the number of its parameters, the parameters; with `then_wait` added to the number, a last
// byte says how many times 5 ms to wait.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace shade16 {

inline constexpr uint8_t then_wait = 0x80;

/// `Bus` has command(byte), data(bytes, count) and delay_ms(ms).
template <class Bus>
constexpr void run_commands(Bus& bus, const uint8_t* list, size_t bytes) {
    for (const uint8_t* const end = list + bytes; list < end;) {
        const uint8_t command = *list++, shape = *list++;
        const size_t count = shape & (then_wait - 1u);
        bus.command(command);
        if (count != 0) bus.data(list, count);
        list += count;
        if ((shape & then_wait) != 0) bus.delay_ms(*list++ * uint32_t{5});
    }
}

}  // namespace shade16
