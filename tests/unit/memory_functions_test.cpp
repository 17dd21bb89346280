// The runtime's memcpy & co against the C library's, at every alignment of both ends.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

// Under other names, so that they do not replace the C library's in this program.
#define memcpy runtime_memcpy
#define memset runtime_memset
#define memmove runtime_memmove
#define memcmp runtime_memcmp
#include <firmware/runtime/memory_functions.cpp>
#undef memcpy
#undef memset
#undef memmove
#undef memcmp

namespace {

using Buffer = std::array<unsigned char, 64>;

Buffer numbered() {
    Buffer buffer{};
    for (size_t i = 0; i < buffer.size(); ++i) buffer[i] = static_cast<unsigned char>(i + 1);
    return buffer;
}

template <class Check>
void at_every_alignment(Check check) {
    for (size_t to = 0; to < 8; ++to) {
        for (size_t from = 0; from < 8; ++from) {
            for (size_t count = 0; count <= 48; ++count) check(to, from, count);
        }
    }
}

TEST(MemoryFunctions, CopyWhatTheyShouldAndNothingElse) {
    at_every_alignment([](size_t to, size_t from, size_t count) {
        const Buffer source = numbered();
        Buffer drawn{}, expected{};
        EXPECT_EQ(runtime_memcpy(&drawn[to], &source[from], count), &drawn[to]);
        std::memcpy(&expected[to], &source[from], count);
        ASSERT_EQ(drawn, expected) << "to " << to << " from " << from << " count " << count;
    });
}

TEST(MemoryFunctions, SetWhatTheyShouldAndNothingElse) {
    at_every_alignment([](size_t to, size_t, size_t count) {
        Buffer drawn = numbered(), expected = numbered();
        EXPECT_EQ(runtime_memset(&drawn[to], 0x1A5, count), &drawn[to]);
        std::memset(&expected[to], 0xA5, count);
        ASSERT_EQ(drawn, expected) << "to " << to << " count " << count;
    });
}

TEST(MemoryFunctions, MoveWithinOneBuffer) {
    at_every_alignment([](size_t to, size_t from, size_t count) {
        Buffer drawn = numbered(), expected = numbered();
        EXPECT_EQ(runtime_memmove(&drawn[to], &drawn[from], count), &drawn[to]);
        std::memmove(&expected[to], &expected[from], count);
        ASSERT_EQ(drawn, expected) << "to " << to << " from " << from << " count " << count;
    });
}

TEST(MemoryFunctions, CompareAsUnsignedBytes) {
    const unsigned char low[] = {1, 2, 3}, high[] = {1, 2, 200};
    EXPECT_LT(runtime_memcmp(low, high, 3), 0);
    EXPECT_GT(runtime_memcmp(high, low, 3), 0);
    EXPECT_EQ(runtime_memcmp(low, high, 2), 0);
    EXPECT_EQ(runtime_memcmp(low, high, 0), 0);
}

}  // namespace
