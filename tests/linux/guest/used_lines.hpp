// Which lines the kernel says are in use, as libgpiod tells.
#pragma once

#include <cstdio>

#include "boards/linux_spi/find_line.hpp"

namespace shade16::linux_spi {

inline int used() {
    int count = 0;
    for (const std::string& path : chips_of("/dev")) {
        const gpio::Chip chip(path);
        for (unsigned offset = 0; offset < chip.line_count(); ++offset)
            if (const gpio::LineInfo line = chip.line(offset); line.used)
                std::printf("in use: %s of %s, by '%s'\n", line.name.c_str(), path.c_str(), line.consumer.c_str()), ++count;
    }
    std::printf("lines in use: %d\n", count);
    return 0;
}

}  // namespace shade16::linux_spi
