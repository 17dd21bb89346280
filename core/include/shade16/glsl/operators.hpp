// Operators of vectors, component by component. Whole numbers saturate as Q16 does; nothing wraps.
#pragma once

#include "shade16/glsl/vector.hpp"

namespace shade16::glsl {

namespace detail {
constexpr Q16 add(Q16 a, Q16 b) { return a + b; }
constexpr Q16 subtract(Q16 a, Q16 b) { return a - b; }
constexpr Q16 times(Q16 a, Q16 b) { return a * b; }
constexpr int32_t add(int32_t a, int32_t b) { return saturate(int64_t{a} + b); }
constexpr int32_t subtract(int32_t a, int32_t b) { return saturate(int64_t{a} - b); }
constexpr int32_t times(int32_t a, int32_t b) { return saturate(multiply(a, b)); }
}  // namespace detail

// The first operand of a pair of vectors decides the type, and the second is converted to it: a swizzle becomes a vector.
// Range   any; a component out of range is the nearest representable number.
// Error   + and - none, * half a unit.
template <NumberVector A>
constexpr Value<A> operator+(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](auto p, auto q) { return detail::add(p, q); }, Value<A>(a), b);
}
template <NumberVector A>
constexpr Value<A> operator-(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](auto p, auto q) { return detail::subtract(p, q); }, Value<A>(a), b);
}
template <NumberVector A>
constexpr Value<A> operator*(const A& a, const Value<A>& b) {
    return detail::each<Value<A>>([](auto p, auto q) { return detail::times(p, q); }, Value<A>(a), b);
}
template <NumberVector A>
constexpr Value<A> operator-(const A& a) {
    return Value<A>(Scalar<A>{}) - a;
}

// With a scalar, which is spread.
template <NumberVector A>
constexpr Value<A> operator+(const A& a, Scalar<A> k) { return a + Value<A>(k); }
template <NumberVector A>
constexpr Value<A> operator+(Scalar<A> k, const A& a) { return Value<A>(k) + a; }
template <NumberVector A>
constexpr Value<A> operator-(const A& a, Scalar<A> k) { return a - Value<A>(k); }
template <NumberVector A>
constexpr Value<A> operator-(Scalar<A> k, const A& a) { return Value<A>(k) - a; }
template <NumberVector A>
constexpr Value<A> operator*(const A& a, Scalar<A> k) { return a * Value<A>(k); }
template <NumberVector A>
constexpr Value<A> operator*(Scalar<A> k, const A& a) { return Value<A>(k) * a; }

template <class T, int N>
constexpr Vector<T, N>& operator+=(Vector<T, N>& a, const Value<Vector<T, N>>& b) { return a = a + b; }
template <class T, int N>
constexpr Vector<T, N>& operator-=(Vector<T, N>& a, const Value<Vector<T, N>>& b) { return a = a - b; }
template <class T, int N>
constexpr Vector<T, N>& operator*=(Vector<T, N>& a, const Value<Vector<T, N>>& b) { return a = a * b; }
template <class T, int N>
constexpr Vector<T, N>& operator+=(Vector<T, N>& a, Scalar<Vector<T, N>> k) { return a = a + k; }
template <class T, int N>
constexpr Vector<T, N>& operator-=(Vector<T, N>& a, Scalar<Vector<T, N>> k) { return a = a - k; }
template <class T, int N>
constexpr Vector<T, N>& operator*=(Vector<T, N>& a, Scalar<Vector<T, N>> k) { return a = a * k; }

/// Whether all components are equal, as in GLSL.
template <AnyVector A, AnyVector B>
    requires(__is_same(Value<A>, Value<B>))
constexpr bool operator==(const A& a, const B& b) {
    const Value<A> p = a, q = b;
    bool same = true;
    for (int i = 0; i < A::size; ++i) same = same && p[i] == q[i];
    return same;
}

namespace detail {
template <class V>
using Bools = Vector<bool, V::size>;
}  // namespace detail

// Comparisons by component; any, all, and not(b), which C++ reads as !b.
template <NumberVector A>
constexpr detail::Bools<A> lessThan(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p < q; }, Value<A>(a), b);
}
template <NumberVector A>
constexpr detail::Bools<A> lessThanEqual(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p <= q; }, Value<A>(a), b);
}
template <NumberVector A>
constexpr detail::Bools<A> greaterThan(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p > q; }, Value<A>(a), b);
}
template <NumberVector A>
constexpr detail::Bools<A> greaterThanEqual(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p >= q; }, Value<A>(a), b);
}
template <AnyVector A>
constexpr detail::Bools<A> equal(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p == q; }, Value<A>(a), b);
}
template <AnyVector A>
constexpr detail::Bools<A> notEqual(const A& a, const Value<A>& b) {
    return detail::each<detail::Bools<A>>([](auto p, auto q) { return p != q; }, Value<A>(a), b);
}
template <BoolVector A>
constexpr bool any(const A& a) { return !(Value<A>(a) == Value<A>(false)); }
template <BoolVector A>
constexpr bool all(const A& a) { return Value<A>(a) == Value<A>(true); }
template <BoolVector A>
constexpr Value<A> operator!(const A& a) {
    return detail::each<Value<A>>([](bool p) { return !p; }, Value<A>(a));
}

}  // namespace shade16::glsl
