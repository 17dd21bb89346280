// View: a pointer and a count. Scene data is plain arrays in flash; the core owns none of it.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace shade16 {

template <class T>
struct View {
    const T* first = nullptr;
    uint32_t count = 0;

    constexpr View() = default;
    constexpr View(const T* f, uint32_t n) : first(f), count(n) {}
    template <size_t N>
    constexpr View(const T (&array)[N]) : first(array), count(static_cast<uint32_t>(N)) {}

    constexpr const T* begin() const { return first; }
    constexpr const T* end() const { return first + count; }
    constexpr const T& operator[](uint32_t i) const { return first[i]; }
    constexpr bool empty() const { return count == 0; }
};

}  // namespace shade16
