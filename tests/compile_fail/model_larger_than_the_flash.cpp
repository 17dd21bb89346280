// EXPECT: the model does not fit the board's flash
#include <runtime/fits.hpp>

struct Board {
    static constexpr shade16::Mesh model = shade16::torus<24, 12>.mesh();
    static constexpr uint32_t ram_bytes = 16 * 1024, flash_bytes = 4 * 1024;
};

static_assert(shade16::must_fit<Board, char[100]>());
