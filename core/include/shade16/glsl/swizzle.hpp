// Swizzles: v.zyx() to read, v.xy() = vec2(1, 2) to write. C++ has no v.zyx without reading inactive members of a union,
// which is undefined and no constant expression; a member function is neither.
#pragma once

#include "shade16/num/bits.hpp"

namespace shade16::glsl {

template <class T, int N>
struct Vector;
template <int N>
struct Matrix;

/// A vector, or a swizzle of one: what the functions take.
template <class V>
concept AnyVector = V::is_glsl_vector;
template <AnyVector V>
using Value = typename V::Value;
template <AnyVector V>
using Scalar = typename V::Scalar;

template <int... I>
constexpr bool each_component_once() {
    uint32_t seen = 0;
    bool once = true;
    ((once = once && !(seen >> I & 1), seen |= uint32_t{1} << I), ...);
    return once;
}

/// Some components of a vector that has a name: converts to their value, and writes through. It refers to the vector:
/// use it in the expression that made it, and keep `vec2 a = v.xy()` rather than `auto a = v.xy()`.
template <class V, int... I>
class Swizzle {
public:
    static constexpr bool is_glsl_vector = true;
    static constexpr int size = sizeof...(I);
    using Scalar = typename V::Scalar;
    using Value = Vector<Scalar, size>;

    constexpr explicit Swizzle(V& of) : of_(of) {}
    constexpr operator Value() const { return Value(of_[I]...); }

    constexpr const Swizzle& operator=(const Value& v) const {
        static_assert(each_component_once<I...>(), "a swizzle that repeats a component is for reading only: v.xx() has one place for two values");
        int next = 0;
        ((of_[I] = v[next++]), ...);
        return *this;
    }
    constexpr const Swizzle& operator=(const Swizzle& other) const { return *this = Value(other); }

    constexpr const Swizzle& operator+=(const Value& v) const { return *this = Value(*this) + v; }
    constexpr const Swizzle& operator-=(const Value& v) const { return *this = Value(*this) - v; }
    constexpr const Swizzle& operator*=(const Value& v) const { return *this = Value(*this) * v; }
    constexpr const Swizzle& operator+=(Scalar k) const { return *this = Value(*this) + k; }
    constexpr const Swizzle& operator-=(Scalar k) const { return *this = Value(*this) - k; }
    constexpr const Swizzle& operator*=(Scalar k) const { return *this = Value(*this) * k; }
    constexpr const Swizzle& operator*=(const Matrix<size>& m) const { return *this = Value(*this) * m; }

private:
    V& of_;
};

}  // namespace shade16::glsl

// The members v.xx() .. v.wwww() of a vector of 2, 3 or 4 components, for one set of letters. Each macro appends a letter.
#define SHADE16_GLSL_WORD(word, ...)                                                                        \
    constexpr Swizzle<Vector, __VA_ARGS__> word()& { return Swizzle<Vector, __VA_ARGS__>(*this); }          \
    constexpr typename Swizzle<Vector, __VA_ARGS__>::Value word() const& { return pick<__VA_ARGS__>(*this); }

#define SHADE16_GLSL_WORDS_2(p, q) SHADE16_GLSL_A_2(p, q, p, 0) SHADE16_GLSL_A_2(p, q, q, 1)
#define SHADE16_GLSL_A_2(p, q, a, i)                              \
    SHADE16_GLSL_WORD(a##p, i, 0) SHADE16_GLSL_WORD(a##q, i, 1)   \
    SHADE16_GLSL_B_2(p, q, a##p, i, 0) SHADE16_GLSL_B_2(p, q, a##q, i, 1)
#define SHADE16_GLSL_B_2(p, q, a, ...)                                                \
    SHADE16_GLSL_WORD(a##p, __VA_ARGS__, 0) SHADE16_GLSL_WORD(a##q, __VA_ARGS__, 1)   \
    SHADE16_GLSL_C_2(p, q, a##p, __VA_ARGS__, 0) SHADE16_GLSL_C_2(p, q, a##q, __VA_ARGS__, 1)
#define SHADE16_GLSL_C_2(p, q, a, ...) SHADE16_GLSL_WORD(a##p, __VA_ARGS__, 0) SHADE16_GLSL_WORD(a##q, __VA_ARGS__, 1)

#define SHADE16_GLSL_WORDS_3(p, q, r) SHADE16_GLSL_A_3(p, q, r, p, 0) SHADE16_GLSL_A_3(p, q, r, q, 1) SHADE16_GLSL_A_3(p, q, r, r, 2)
#define SHADE16_GLSL_A_3(p, q, r, a, i)                                                          \
    SHADE16_GLSL_WORD(a##p, i, 0) SHADE16_GLSL_WORD(a##q, i, 1) SHADE16_GLSL_WORD(a##r, i, 2)    \
    SHADE16_GLSL_B_3(p, q, r, a##p, i, 0) SHADE16_GLSL_B_3(p, q, r, a##q, i, 1) SHADE16_GLSL_B_3(p, q, r, a##r, i, 2)
#define SHADE16_GLSL_B_3(p, q, r, a, ...)                                                                                         \
    SHADE16_GLSL_WORD(a##p, __VA_ARGS__, 0) SHADE16_GLSL_WORD(a##q, __VA_ARGS__, 1) SHADE16_GLSL_WORD(a##r, __VA_ARGS__, 2)       \
    SHADE16_GLSL_C_3(p, q, r, a##p, __VA_ARGS__, 0) SHADE16_GLSL_C_3(p, q, r, a##q, __VA_ARGS__, 1)                               \
    SHADE16_GLSL_C_3(p, q, r, a##r, __VA_ARGS__, 2)
#define SHADE16_GLSL_C_3(p, q, r, a, ...) \
    SHADE16_GLSL_WORD(a##p, __VA_ARGS__, 0) SHADE16_GLSL_WORD(a##q, __VA_ARGS__, 1) SHADE16_GLSL_WORD(a##r, __VA_ARGS__, 2)

#define SHADE16_GLSL_WORDS_4(p, q, r, s)                                        \
    SHADE16_GLSL_A_4(p, q, r, s, p, 0) SHADE16_GLSL_A_4(p, q, r, s, q, 1)       \
    SHADE16_GLSL_A_4(p, q, r, s, r, 2) SHADE16_GLSL_A_4(p, q, r, s, s, 3)
#define SHADE16_GLSL_A_4(p, q, r, s, a, i)                                                                                    \
    SHADE16_GLSL_WORD(a##p, i, 0) SHADE16_GLSL_WORD(a##q, i, 1) SHADE16_GLSL_WORD(a##r, i, 2) SHADE16_GLSL_WORD(a##s, i, 3)   \
    SHADE16_GLSL_B_4(p, q, r, s, a##p, i, 0) SHADE16_GLSL_B_4(p, q, r, s, a##q, i, 1)                                         \
    SHADE16_GLSL_B_4(p, q, r, s, a##r, i, 2) SHADE16_GLSL_B_4(p, q, r, s, a##s, i, 3)
#define SHADE16_GLSL_B_4(p, q, r, s, a, ...)                                                                  \
    SHADE16_GLSL_C_4(p, q, r, s, a, __VA_ARGS__)                                                              \
    SHADE16_GLSL_C_4(p, q, r, s, a##p, __VA_ARGS__, 0) SHADE16_GLSL_C_4(p, q, r, s, a##q, __VA_ARGS__, 1)     \
    SHADE16_GLSL_C_4(p, q, r, s, a##r, __VA_ARGS__, 2) SHADE16_GLSL_C_4(p, q, r, s, a##s, __VA_ARGS__, 3)
#define SHADE16_GLSL_C_4(p, q, r, s, a, ...)                                                  \
    SHADE16_GLSL_WORD(a##p, __VA_ARGS__, 0) SHADE16_GLSL_WORD(a##q, __VA_ARGS__, 1)           \
    SHADE16_GLSL_WORD(a##r, __VA_ARGS__, 2) SHADE16_GLSL_WORD(a##s, __VA_ARGS__, 3)

// v.r() and v.s() are references, as v.x is a member.
#define SHADE16_GLSL_LETTER(letter, member)          \
    constexpr T& letter()& { return member; }        \
    constexpr T letter() const& { return member; }
