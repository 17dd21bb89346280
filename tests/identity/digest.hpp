// A hash of numbers, each taken as its bytes, the lowest first, whatever the machine's own order and lengths are.
#pragma once

#include <runtime/fnv1a.hpp>

#include "shade16/num/block.hpp"
#include "shade16/num/unorm.hpp"

namespace shade16::identity {

/// Two results of one kernel.
template <class A, class B>
struct Both {
    A a;
    B b;
};
template <class A, class B>
Both(A, B) -> Both<A, B>;

class Digest {
public:
    constexpr void add(uint32_t x) {
        for (int at = 0; at < 4; ++at, x >>= 8) hash_.add(static_cast<uint8_t>(x));
    }
    constexpr void add(int32_t x) { add(static_cast<uint32_t>(x)); }
    constexpr void add(uint64_t x) { add(static_cast<uint32_t>(x)), add(static_cast<uint32_t>(x >> 32)); }
    constexpr void add(int64_t x) { add(static_cast<uint64_t>(x)); }
    constexpr void add(Scaled x) { add(x.mantissa), add(int32_t{x.exponent}); }
    constexpr void add(const Block& x) { add(x.mantissa), add(static_cast<int32_t>(x.exponent)); }
    constexpr void add(const BlockVector& v) { add(v.x), add(v.y), add(v.z); }
    constexpr void add(Q16 x) { add(x.raw); }
    constexpr void add(Q30 x) { add(x.raw); }
    constexpr void add(Unit14 x) { add(int32_t{x.raw}); }
    constexpr void add(Angle x) { add(x.turns); }
    constexpr void add(SinCos x) { add(x.sin), add(x.cos); }
    constexpr void add(ColorFactor c) { add(c.r), add(c.g), add(c.b); }
    template <class T>
    constexpr void add(const Vector3<T>& v) { add(v.x), add(v.y), add(v.z); }
    constexpr void add(const Mat3& m) { add(m.row[0]), add(m.row[1]), add(m.row[2]); }

    template <class A, class B>
    constexpr void add(const Both<A, B>& x) { add(x.a), add(x.b); }

    constexpr uint32_t value() const { return hash_.value; }

private:
    Fnv1a hash_{};
};

}  // namespace shade16::identity
