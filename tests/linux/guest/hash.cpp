// Prints the hash of the guest's frame as this computer draws it.
#include <cstdio>

#include "tests/linux/guest/picture.hpp"

int main() {
    using namespace shade16::linux_spi;
    std::printf("%08X\n", static_cast<unsigned>(hash_of(torus_codes())));
}
