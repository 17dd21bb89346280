// Whether an app's memory fits its board, said while compiling and with the bytes that it lacks; the linker would only say it at the end.
#pragma once

#include <shade16/shade16.hpp>

namespace shade16 {

/// What every app needs besides its own: variables of the runtime, and a stack.
inline constexpr size_t least_stack_bytes = 2400;

/// What a mesh takes in flash.
constexpr size_t flash_bytes_of(const Mesh& m) {
    return m.positions.count * sizeof(Position16) + m.normals.count * sizeof(Normal14) + m.colors.count * sizeof(Rgb) +
           m.texcoords.count * sizeof(TexCoord16) + m.triangles.count * sizeof(Triangle);
}

/// The compiler prints the template's arguments: how many bytes are not there.
template <size_t LacksBytesOfRam>
constexpr bool ram_suffices() {
    static_assert(LacksBytesOfRam == 0, "the workspace and the bands do not fit the board's RAM: make the bands smaller, take one instead of two, or replay vertices");
    return true;
}
template <size_t LacksBytesOfFlash>
constexpr bool flash_suffices() {
    static_assert(LacksBytesOfFlash == 0, "the model does not fit the board's flash: bake one with fewer triangles");
    return true;
}

/// `Variables` are those that an app keeps for good.
template <class Board, class... Variables>
constexpr bool must_fit() {
    constexpr size_t ram = (sizeof(Variables) + ... + least_stack_bytes), flash = flash_bytes_of(Board::model);
    return ram_suffices<(ram > Board::ram_bytes ? ram - Board::ram_bytes : 0)>() && flash_suffices<(flash > Board::flash_bytes ? flash - Board::flash_bytes : 0)>();
}

}  // namespace shade16
