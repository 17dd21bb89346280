// vec2 .. vec4, ivec2 .. ivec4, bvec2 .. bvec4: members x, y, z, w, GLSL's constructors and swizzles.
#pragma once

#include "shade16/glsl/swizzle.hpp"
#include "shade16/num/vec.hpp"

namespace shade16::glsl {

using shade16::Q16;
using shade16::operator""_q16;

namespace detail {
/// A component of one type as another, as GLSL's constructors convert: whole numbers saturate, fractions are cut off.
template <class T>
struct As;
template <>
struct As<Q16> {
    static constexpr Q16 of(Q16 x) { return x; }
    static constexpr Q16 of(int32_t x) { return Q16::from_int(x); }
    static constexpr Q16 of(bool x) { return Q16::from_int(x ? 1 : 0); }
};
template <>
struct As<int32_t> {
    static constexpr int32_t of(Q16 x) { return x.raw < 0 ? -static_cast<int32_t>(magnitude(x.raw) >> 16) : x.raw >> 16; }
    static constexpr int32_t of(int32_t x) { return x; }
    static constexpr int32_t of(bool x) { return x ? 1 : 0; }
};
template <>
struct As<bool> {
    static constexpr bool of(Q16 x) { return x.raw != 0; }
    static constexpr bool of(int32_t x) { return x != 0; }
    static constexpr bool of(bool x) { return x; }
};

/// Whether GLSL makes a vector of n components of type T from a V: a longer one is cut, one of another type converted.
template <class V, class T, int N>
concept MakesA = AnyVector<V> && V::size >= N && !__is_same(typename V::Value, Vector<T, N>) &&
                 (V::size == N || __is_same(typename V::Scalar, T));
}  // namespace detail

template <int... I, class T, int N>
SHADE16_INLINE constexpr Vector<T, static_cast<int>(sizeof...(I))> pick(const Vector<T, N>& v) {
    return Vector<T, static_cast<int>(sizeof...(I))>(v[I]...);
}

template <class T>
struct Vector<T, 2> {
    static constexpr bool is_glsl_vector = true;
    static constexpr int size = 2;
    using Scalar = T;
    using Value = Vector;

    T x{}, y{};

    constexpr Vector() = default;
    constexpr explicit Vector(T all) : x(all), y(all) {}
    constexpr Vector(T x0, T y0) : x(x0), y(y0) {}
    template <detail::MakesA<T, 2> V>
    constexpr explicit Vector(const V& of) {
        const typename V::Value v = of;
        x = detail::As<T>::of(v.x), y = detail::As<T>::of(v.y);
    }

    /// The component; the nearest one for an index out of range.
    constexpr T& operator[](int i) { return i <= 0 ? x : y; }
    constexpr const T& operator[](int i) const { return i <= 0 ? x : y; }

    SHADE16_GLSL_LETTER(r, x) SHADE16_GLSL_LETTER(g, y)
    SHADE16_GLSL_LETTER(s, x) SHADE16_GLSL_LETTER(t, y)
    SHADE16_GLSL_WORDS_2(x, y)
    SHADE16_GLSL_WORDS_2(r, g)
    SHADE16_GLSL_WORDS_2(s, t)
};

template <class T>
struct Vector<T, 3> {
    static constexpr bool is_glsl_vector = true;
    static constexpr int size = 3;
    using Scalar = T;
    using Value = Vector;
    using Two = Vector<T, 2>;

    T x{}, y{}, z{};

    constexpr Vector() = default;
    constexpr explicit Vector(T all) : x(all), y(all), z(all) {}
    constexpr Vector(T x0, T y0, T z0) : x(x0), y(y0), z(z0) {}
    constexpr Vector(const Two& xy0, T z0) : x(xy0.x), y(xy0.y), z(z0) {}
    constexpr Vector(T x0, const Two& yz0) : x(x0), y(yz0.x), z(yz0.y) {}
    template <detail::MakesA<T, 3> V>
    constexpr explicit Vector(const V& of) {
        const typename V::Value v = of;
        x = detail::As<T>::of(v.x), y = detail::As<T>::of(v.y), z = detail::As<T>::of(v.z);
    }
    /// From and to the engine's own positions and directions.
    constexpr explicit Vector(Vec3 v) requires(__is_same(T, Q16)) : x(v.x), y(v.y), z(v.z) {}
    constexpr explicit operator Vec3() const requires(__is_same(T, Q16)) { return {x, y, z}; }

    constexpr T& operator[](int i) { return i <= 0 ? x : i == 1 ? y : z; }
    constexpr const T& operator[](int i) const { return i <= 0 ? x : i == 1 ? y : z; }

    SHADE16_GLSL_LETTER(r, x) SHADE16_GLSL_LETTER(g, y) SHADE16_GLSL_LETTER(b, z)
    SHADE16_GLSL_LETTER(s, x) SHADE16_GLSL_LETTER(t, y) SHADE16_GLSL_LETTER(p, z)
    SHADE16_GLSL_WORDS_3(x, y, z)
    SHADE16_GLSL_WORDS_3(r, g, b)
    SHADE16_GLSL_WORDS_3(s, t, p)
};

template <class T>
struct Vector<T, 4> {
    static constexpr bool is_glsl_vector = true;
    static constexpr int size = 4;
    using Scalar = T;
    using Value = Vector;
    using Two = Vector<T, 2>;
    using Three = Vector<T, 3>;

    T x{}, y{}, z{}, w{};

    constexpr Vector() = default;
    constexpr explicit Vector(T all) : x(all), y(all), z(all), w(all) {}
    constexpr Vector(T x0, T y0, T z0, T w0) : x(x0), y(y0), z(z0), w(w0) {}
    constexpr Vector(const Two& xy0, T z0, T w0) : x(xy0.x), y(xy0.y), z(z0), w(w0) {}
    constexpr Vector(T x0, const Two& yz0, T w0) : x(x0), y(yz0.x), z(yz0.y), w(w0) {}
    constexpr Vector(T x0, T y0, const Two& zw0) : x(x0), y(y0), z(zw0.x), w(zw0.y) {}
    constexpr Vector(const Two& xy0, const Two& zw0) : x(xy0.x), y(xy0.y), z(zw0.x), w(zw0.y) {}
    constexpr Vector(const Three& xyz0, T w0) : x(xyz0.x), y(xyz0.y), z(xyz0.z), w(w0) {}
    constexpr Vector(T x0, const Three& yzw0) : x(x0), y(yzw0.x), z(yzw0.y), w(yzw0.z) {}
    template <detail::MakesA<T, 4> V>
    constexpr explicit Vector(const V& of) {
        const typename V::Value v = of;
        x = detail::As<T>::of(v.x), y = detail::As<T>::of(v.y), z = detail::As<T>::of(v.z), w = detail::As<T>::of(v.w);
    }

    constexpr T& operator[](int i) { return i <= 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr const T& operator[](int i) const { return i <= 0 ? x : i == 1 ? y : i == 2 ? z : w; }

    SHADE16_GLSL_LETTER(r, x) SHADE16_GLSL_LETTER(g, y) SHADE16_GLSL_LETTER(b, z) SHADE16_GLSL_LETTER(a, w)
    SHADE16_GLSL_LETTER(s, x) SHADE16_GLSL_LETTER(t, y) SHADE16_GLSL_LETTER(p, z) SHADE16_GLSL_LETTER(q, w)
    SHADE16_GLSL_WORDS_4(x, y, z, w)
    SHADE16_GLSL_WORDS_4(r, g, b, a)
    SHADE16_GLSL_WORDS_4(s, t, p, q)
};

using vec2 = Vector<Q16, 2>;
using vec3 = Vector<Q16, 3>;
using vec4 = Vector<Q16, 4>;
using ivec2 = Vector<int32_t, 2>;
using ivec3 = Vector<int32_t, 3>;
using ivec4 = Vector<int32_t, 4>;
using bvec2 = Vector<bool, 2>;
using bvec3 = Vector<bool, 3>;
using bvec4 = Vector<bool, 4>;

template <class V>
concept FloatVector = AnyVector<V> && __is_same(typename V::Scalar, Q16);
template <class V>
concept IntVector = AnyVector<V> && __is_same(typename V::Scalar, int32_t);
template <class V>
concept BoolVector = AnyVector<V> && __is_same(typename V::Scalar, bool);
template <class V>
concept NumberVector = FloatVector<V> || IntVector<V>;

namespace detail {
/// The vector of f of each component of the vectors.
template <class R, class F, class... V>
SHADE16_INLINE constexpr R each(F f, const V&... v) {
    if constexpr (R::size == 2) return R(f(v.x...), f(v.y...));
    else if constexpr (R::size == 3) return R(f(v.x...), f(v.y...), f(v.z...));
    else return R(f(v.x...), f(v.y...), f(v.z...), f(v.w...));
}

/// The sum of f of each component, or of pairs of them.
template <class F, class V, class... W>
SHADE16_INLINE constexpr auto sum_of(F f, const V& v, const W&... w) {
    auto sum = f(v.x, w.x...) + f(v.y, w.y...);
    if constexpr (V::size > 2) sum += f(v.z, w.z...);
    if constexpr (V::size > 3) sum += f(v.w, w.w...);
    return sum;
}

/// f(0), f(1), ..: as many as R has parts. Not a loop: an index that is known costs nothing.
template <class R, class F>
SHADE16_INLINE constexpr R by_index(F f) {
    if constexpr (R::size == 2) return R(f(0), f(1));
    else if constexpr (R::size == 3) return R(f(0), f(1), f(2));
    else return R(f(0), f(1), f(2), f(3));
}
}  // namespace detail

}  // namespace shade16::glsl

#undef SHADE16_GLSL_WORD
#undef SHADE16_GLSL_WORDS_2
#undef SHADE16_GLSL_A_2
#undef SHADE16_GLSL_B_2
#undef SHADE16_GLSL_C_2
#undef SHADE16_GLSL_WORDS_3
#undef SHADE16_GLSL_A_3
#undef SHADE16_GLSL_B_3
#undef SHADE16_GLSL_C_3
#undef SHADE16_GLSL_WORDS_4
#undef SHADE16_GLSL_A_4
#undef SHADE16_GLSL_B_4
#undef SHADE16_GLSL_C_4
#undef SHADE16_GLSL_LETTER
