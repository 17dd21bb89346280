// Bytes as a PNG file: a texture and a relief as the core has them, or a refusal. Mutated chunks get their checksums anew, which
// otherwise hardly any of them would get past.
#include <cstring>

#include <zlib.h>

#include "host_sim/model/texture_file.hpp"
#include "tests/fuzz/contract.hpp"
#include "tests/system/scratch_directory.hpp"

extern "C" std::size_t LLVMFuzzerMutate(uint8_t* data, std::size_t size, std::size_t max_size);

namespace shade16::fuzz {
namespace {

uint32_t big_endian(const uint8_t* p) { return uint32_t{p[0]} << 24 | uint32_t{p[1]} << 16 | uint32_t{p[2]} << 8 | p[3]; }

/// Signature; then length, name, data and checksum of name and data a chunk.
void mend_checksums(uint8_t* data, std::size_t size) {
    for (std::size_t at = 8; at + 12 <= size;) {
        const std::size_t length = big_endian(data + at), next = at + 12 + length;
        if (next > size) return;
        const auto sum = static_cast<uint32_t>(crc32(0, data + at + 4, static_cast<unsigned>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i) data[next - 4 + i] = static_cast<uint8_t>(sum >> (24 - 8 * i));
        at = next;
    }
}

/// As many as the sides say, which are those that the core allows.
template <class Map>
void expect_whole(const Map& map) {
    if (map.width_log2 > 10 || map.height_log2 > 10) break_contract("A map is larger than 1024 a side.");
    if (map.texels.count != uint32_t{1} << (map.width_log2 + map.height_log2)) break_contract("A map has another number of texels than its sides say.");
}

}  // namespace
}  // namespace shade16::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(uint8_t* data, std::size_t size, std::size_t max_size, unsigned) {
    size = LLVMFuzzerMutate(data, size, max_size);
    shade16::fuzz::mend_checksums(data, size);
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace shade16;
    static const host::ScratchDirectory scratch;
    const std::string path = scratch.write("picture.png", fuzz::as_text(data, size));
    fuzz::is_accepted("picture.png", [&] {
        std::vector<std::string> warnings;
        fuzz::expect_whole(host::read_texture(path, warnings)->texture);
        const auto relief = host::read_relief(path, static_cast<double>(size % 201) - 100, static_cast<host::ReliefKind>(size % 3), warnings);
        fuzz::expect_whole(relief->map);
        if (relief->map.fraction_bits < 4 || relief->map.fraction_bits > 11)
            fuzz::break_contract("A relief has fraction bits that the core does not know.");
    });
    return 0;
}
