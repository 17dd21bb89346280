// Prints the hash of the guest's frame as this computer draws it; or, of the bytes of a file, that of a frame which another program drew.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/linux/guest/picture.hpp"

namespace {

uint32_t hash_of_file(const char* path) {
    shade16::Fnv1a hash;
    std::ifstream file(path, std::ios::binary);
    for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte) hash.add(static_cast<uint8_t>(*byte));
    return hash.value;
}

}  // namespace

int main(int count, char** words) {
    using namespace shade16::linux_spi;
    std::printf("%08X\n", static_cast<unsigned>(count > 1 ? hash_of_file(words[1]) : hash_of(torus_codes())));
}
