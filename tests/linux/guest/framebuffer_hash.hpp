// What a framebuffer shows, as a hash.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>

#include "host_sim/error.hpp"
#include "runtime/fnv1a.hpp"

namespace shade16::linux_spi {

/// Of 16 bits a pixel all bytes count as they lie there; of 32 red, green and blue.
inline int framebuffer_hash(const std::string& device, int bits, int pixels) {
    Fnv1a hash;
    std::ifstream file(device, std::ios::binary);
    unsigned char pixel[4]{};
    for (int i = 0; i < pixels; ++i) {
        if (!file.read(reinterpret_cast<char*>(pixel), bits / 8)) throw host::io_error("{}: ends after {} pixels; expected {}.", device, i, pixels);
        if (bits == 16) hash.add(pixel[0]), hash.add(pixel[1]);
        else hash.add(pixel[2]), hash.add(pixel[1]), hash.add(pixel[0]);
    }
    std::printf("seen %08X\n", static_cast<unsigned>(hash.value));
    return 0;
}

}  // namespace shade16::linux_spi
