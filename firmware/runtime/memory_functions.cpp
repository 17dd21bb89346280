// The four functions that a compiler calls unasked. It may assume that they exist even where there is no C library.
// Compiled with -fno-builtin and -fno-tree-loop-distribute-patterns (see firmware/CMakeLists.txt): otherwise the
// compiler recognises these loops and makes memcpy call memcpy.
#include <stddef.h>
#include <stdint.h>

namespace {

using Byte = uint8_t;
using Word [[gnu::may_alias]] = uint32_t;

constexpr size_t word_bytes = sizeof(Word);
constexpr size_t block_bytes = 4 * word_bytes;  // worth one branch

uintptr_t misalignment(const void* address) { return reinterpret_cast<uintptr_t>(address) % word_bytes; }

}  // namespace

extern "C" {

void* memcpy(void* __restrict to, const void* __restrict from, size_t count) {
    auto* out = static_cast<Byte*>(to);
    auto* in = static_cast<const Byte*>(from);
    // Words only if both ends can be aligned together: a Cortex-M0 faults on an unaligned word.
    if (misalignment(out) == misalignment(in)) {
        for (; count && misalignment(out); --count) *out++ = *in++;
        auto* words_out = reinterpret_cast<Word*>(out);
        auto* words_in = reinterpret_cast<const Word*>(in);
        for (; count >= block_bytes; count -= block_bytes, words_out += 4, words_in += 4) {
            const Word a = words_in[0], b = words_in[1], c = words_in[2], d = words_in[3];
            words_out[0] = a, words_out[1] = b, words_out[2] = c, words_out[3] = d;
        }
        for (; count >= word_bytes; count -= word_bytes) *words_out++ = *words_in++;
        out = reinterpret_cast<Byte*>(words_out);
        in = reinterpret_cast<const Byte*>(words_in);
    }
    for (; count; --count) *out++ = *in++;
    return to;
}

void* memset(void* to, int value, size_t count) {
    auto* out = static_cast<Byte*>(to);
    const auto byte = static_cast<Byte>(value);
    for (; count && misalignment(out); --count) *out++ = byte;
    const Word word = byte * Word{0x01010101};
    auto* words = reinterpret_cast<Word*>(out);
    for (; count >= block_bytes; count -= block_bytes, words += 4) {
        words[0] = word, words[1] = word, words[2] = word, words[3] = word;
    }
    for (; count >= word_bytes; count -= word_bytes) *words++ = word;
    out = reinterpret_cast<Byte*>(words);
    for (; count; --count) *out++ = byte;
    return to;
}

void* memmove(void* to, const void* from, size_t count) {
    auto* out = static_cast<Byte*>(to);
    auto* in = static_cast<const Byte*>(from);
    if (out < in) {
        for (; count; --count) *out++ = *in++;
    } else {
        while (count--) out[count] = in[count];
    }
    return to;
}

int memcmp(const void* left, const void* right, size_t count) {
    auto* a = static_cast<const Byte*>(left);
    auto* b = static_cast<const Byte*>(right);
    for (; count; --count, ++a, ++b) {
        if (*a != *b) return *a - *b;
    }
    return 0;
}
}
