// What /dev/wire_recorder gives: one change of its lines after another. For the kernel and for programs.
#pragma once

#include <linux/types.h>

enum wire { wire_clock, wire_data, wire_select, wire_command, wire_reset, wire_light, wire_count };

struct wire_change {
    __u32 at_us;   // since the kernel began; all over again after 71 minutes
    __u32 levels;  // of all lines from then on: bit 1 << wire_clock and so on
};
