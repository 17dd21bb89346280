// Errors of numbers that float, against long double: on x86-64 that has a mantissa of 64 bits.
#pragma once

#include <cmath>

#include "shade16/num/scaled.hpp"

namespace shade16::bounds {

inline long double wide(Scaled s) { return std::ldexp(static_cast<long double>(s.mantissa), s.exponent - 32); }

inline double relative_error(long double got, long double exact) {
    return static_cast<double>(std::fabs(got / exact - 1));
}

}  // namespace shade16::bounds
