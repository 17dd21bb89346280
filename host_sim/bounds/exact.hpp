// For what must be exact: the distance from the right result, in units of the result.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shade16::bounds {

__extension__ using Wide = __int128;
__extension__ using WideUnsigned = unsigned __int128;

/// floor((x + 2^(n-1)) / 2^n): rounded half up.
inline Wide rounded_half_up(Wide x, int n) { return n == 0 ? x : (x + (Wide{1} << (n - 1))) >> n; }

inline Wide nearest_word(Wide x) { return std::clamp<Wide>(x, INT32_MIN, INT32_MAX); }

class Differences {
public:
    template <class A, class B>
    Differences& operator()(const A& got, const B& wanted) {
        const Wide apart = Wide{got} - Wide{wanted};
        if (apart != 0) largest_ = std::max(largest_, std::fabs(static_cast<double>(apart)));
        return *this;
    }
    operator double() const { return largest_; }

private:
    double largest_ = 0;
};

}  // namespace shade16::bounds
