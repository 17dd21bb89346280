// A function that promises nothing: public_functions.py must find it.
#pragma once

#include <stdint.h>

namespace shade16 {
constexpr int32_t about_twice(int32_t x) { return x + x / 2 * 2; }
}  // namespace shade16
