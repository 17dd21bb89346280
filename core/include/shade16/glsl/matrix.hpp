// mat2, mat3, mat4: by columns, as in GLSL. m[i] is a column, m[i][j] the entry in column i and row j.
#pragma once

#include "shade16/glsl/operators.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16::glsl {

template <int N>
struct Matrix {
    static constexpr int size = N;
    using Column = Vector<Q16, N>;

    Column column[static_cast<size_t>(N)]{};

    /// All entries 0 (GLSL leaves them undefined); mat4(1) is the identity.
    constexpr Matrix() = default;
    constexpr explicit Matrix(Q16 diagonal) {
        for (int i = 0; i < N; ++i) column[i][i] = diagonal;
    }
    constexpr Matrix(const Column& c0, const Column& c1) requires(N == 2) : column{c0, c1} {}
    constexpr Matrix(const Column& c0, const Column& c1, const Column& c2) requires(N == 3) : column{c0, c1, c2} {}
    constexpr Matrix(const Column& c0, const Column& c1, const Column& c2, const Column& c3) requires(N == 4) : column{c0, c1, c2, c3} {}
    /// Entries, column by column: m01 stands in column 0 and row 1.
    constexpr Matrix(Q16 m00, Q16 m01, Q16 m10, Q16 m11) requires(N == 2) : column{{m00, m01}, {m10, m11}} {}
    constexpr Matrix(Q16 m00, Q16 m01, Q16 m02, Q16 m10, Q16 m11, Q16 m12, Q16 m20, Q16 m21, Q16 m22) requires(N == 3)
        : column{{m00, m01, m02}, {m10, m11, m12}, {m20, m21, m22}} {}
    constexpr Matrix(Q16 m00, Q16 m01, Q16 m02, Q16 m03, Q16 m10, Q16 m11, Q16 m12, Q16 m13, Q16 m20, Q16 m21, Q16 m22, Q16 m23, Q16 m30,
                     Q16 m31, Q16 m32, Q16 m33) requires(N == 4)
        : column{{m00, m01, m02, m03}, {m10, m11, m12, m13}, {m20, m21, m22, m23}, {m30, m31, m32, m33}} {}
    /// The upper left part of a larger matrix; a smaller one is set into the identity.
    template <int M>
        requires(M != N)
    constexpr explicit Matrix(const Matrix<M>& of) : Matrix(Q16::from_int(1)) {
        for (int i = 0; i < N && i < M; ++i)
            for (int j = 0; j < N && j < M; ++j) column[i][j] = of.column[i][j];
    }

    /// The column; the nearest one for an index out of range.
    constexpr Column& operator[](int i) { return column[shade16::clamp<int>(i, 0, N - 1)]; }
    constexpr const Column& operator[](int i) const { return column[shade16::clamp<int>(i, 0, N - 1)]; }

    friend constexpr bool operator==(const Matrix& a, const Matrix& b) {
        bool same = true;
        for (int i = 0; i < N; ++i) same = same && a.column[i] == b.column[i];
        return same;
    }
};

using mat2 = Matrix<2>;
using mat3 = Matrix<3>;
using mat4 = Matrix<4>;

inline constexpr Ulps dot_max_error = 0.501_ulps;

/// a.b
/// Range   any: the products are summed in 64 bits with 30 fraction bits; the sum saturates.
/// Error   dot_max_error.  Cost  a long multiply a component.
template <FloatVector A>
constexpr Q16 dot(const A& a, const Value<A>& b) {
    const int64_t sum = detail::sum_of([](Q16 p, Q16 q) { return multiply(p.raw, q.raw) >> 2; }, Value<A>(a), b);
    return Q16::from_raw(saturate(shift_right_round(sum, 14)));
}
constexpr Q16 dot(Q16 a, Q16 b) { return a * b; }

template <int N>
constexpr Matrix<N> transpose(const Matrix<N>& m) {
    return detail::by_index<Matrix<N>>([&m](int row) {
        return detail::by_index<Vector<Q16, N>>([&m, row](int i) { return m.column[i][row]; });
    });
}

/// Products of matrices and vectors. v * m takes v for a row, m * v for a column.
/// Range   any; entries saturate.  Error  dot_max_error an entry.  Cost  a dot an entry.
template <int N>
constexpr Vector<Q16, N> operator*(const typename Matrix<N>::Column& v, const Matrix<N>& m) {
    return detail::by_index<Vector<Q16, N>>([&](int i) { return dot(v, m.column[i]); });
}
template <int N>
constexpr Vector<Q16, N> operator*(const Matrix<N>& m, const typename Matrix<N>::Column& v) { return v * transpose(m); }
template <int N>
constexpr Matrix<N> operator*(const Matrix<N>& a, const Matrix<N>& b) {
    const Matrix<N> rows = transpose(a);
    Matrix<N> result;
    for (int i = 0; i < N; ++i) result.column[i] = b.column[i] * rows;
    return result;
}

namespace detail {
template <int N, class F>
SHADE16_INLINE constexpr Matrix<N> each_column(const Matrix<N>& a, const Matrix<N>& b, F f) {
    Matrix<N> result;
    for (int i = 0; i < N; ++i) result.column[i] = f(a.column[i], b.column[i]);
    return result;
}
}  // namespace detail

template <int N>
constexpr Matrix<N> operator+(const Matrix<N>& a, const Matrix<N>& b) {
    return detail::each_column(a, b, [](const auto& p, const auto& q) { return p + q; });
}
template <int N>
constexpr Matrix<N> operator-(const Matrix<N>& a, const Matrix<N>& b) {
    return detail::each_column(a, b, [](const auto& p, const auto& q) { return p - q; });
}
template <int N>
constexpr Matrix<N> operator-(const Matrix<N>& a) { return Matrix<N>() - a; }
template <int N>
constexpr Matrix<N> operator*(const Matrix<N>& a, Q16 k) {
    return detail::each_column(a, a, [k](const auto& p, const auto&) { return p * k; });
}
template <int N>
constexpr Matrix<N> operator*(Q16 k, const Matrix<N>& a) { return a * k; }
/// Entry by entry, which is what * is for vectors.
template <int N>
constexpr Matrix<N> matrixCompMult(const Matrix<N>& a, const Matrix<N>& b) {
    return detail::each_column(a, b, [](const auto& p, const auto& q) { return p * q; });
}
/// The matrix a * b of a column and a row.
template <FloatVector A>
constexpr Matrix<A::size> outerProduct(const A& a, const Value<A>& b) {
    Matrix<A::size> result;
    for (int i = 0; i < A::size; ++i) result.column[i] = a * b[i];
    return result;
}

template <int N>
constexpr Matrix<N>& operator+=(Matrix<N>& a, const Matrix<N>& b) { return a = a + b; }
template <int N>
constexpr Matrix<N>& operator-=(Matrix<N>& a, const Matrix<N>& b) { return a = a - b; }
template <int N>
constexpr Matrix<N>& operator*=(Matrix<N>& a, const Matrix<N>& b) { return a = a * b; }
template <int N>
constexpr Matrix<N>& operator*=(Matrix<N>& a, Q16 k) { return a = a * k; }
template <int N>
constexpr Vector<Q16, N>& operator*=(Vector<Q16, N>& v, const Matrix<N>& m) { return v = v * m; }

}  // namespace shade16::glsl
