// EXPECT: 61794
#include <runtime/fits.hpp>

struct Board {
    static constexpr shade16::Mesh model{};
    static constexpr uint32_t ram_bytes = 16 * 1024, flash_bytes = 64 * 1024;
};

static_assert(shade16::must_fit<Board, shade16::BandBuffer<shade16::Rgb565, 320, 40, false>[2], char[24'574]>());
