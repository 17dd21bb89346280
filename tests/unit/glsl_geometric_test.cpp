#include "shade16/glsl/geometric.hpp"

#include "unit/glsl_error.hpp"

namespace shade16::glsl {
namespace {

constexpr Q16 largest = Q16::from_raw(INT32_MAX), smallest = Q16::from_raw(INT32_MIN);

long double wide(Q16 x) { return static_cast<long double>(x.raw) / 65536; }

template <class V>
V any_vector(AnyNumber& any) {
    V v;
    const int bits = 1 + static_cast<int>(any.bits() % 32);
    for (int i = 0; i < V::size; ++i) v[i] = any.bits() % 16 == 0 ? any() : any.of_bits(bits);
    return v;
}

template <class V>
long double exact_dot(const V& a, const V& b) {
    long double sum = 0;
    for (int i = 0; i < V::size; ++i) sum += static_cast<long double>(a[i].raw) * b[i].raw;
    return sum / 65536 / 65536;
}

template <class V>
V unit_vector(AnyNumber& any) {
    V v;
    do v = normalize(any_vector<V>(any));
    while (v == V());
    return v;
}

template <class V>
void check_lengths(Worst& dots, Worst& lengths, Worst& distances, Worst& units) {
    AnyNumber any(21);
    for (int i = 0; i < 400'000; ++i) {
        const V a = any_vector<V>(any), b = any_vector<V>(any);
        dots.add(dot(a, b), static_cast<double>(exact_dot(a, b)));
        const long double exact = std::sqrt(exact_dot(a, a));
        lengths.add(length(a), static_cast<double>(exact));
        long double between = 0;
        for (int k = 0; k < V::size; ++k) between += std::pow(static_cast<long double>(a[k].raw) - b[k].raw, 2.0L);
        distances.add(distance(a, b), static_cast<double>(std::sqrt(between) / 65536));
        const V n = normalize(a);
        for (int k = 0; k < V::size; ++k) units.add(n[k], exact == 0 ? 0 : static_cast<double>(wide(a[k]) / exact));
    }
}

TEST(GlslGeometric, DotLengthDistanceNormalize) {
    Worst dots("dot"), lengths("length"), distances("distance"), units("normalize");
    check_lengths<vec2>(dots, lengths, distances, units);
    check_lengths<vec3>(dots, lengths, distances, units);
    check_lengths<vec4>(dots, lengths, distances, units);
    dots.expect(dot_max_error);
    lengths.expect(length_max_error);
    distances.expect(length_max_error);
    units.expect(normalize_max_error);
}

TEST(GlslGeometric, TheSmallestAndTheLargestVectorsHaveLengths) {
    constexpr Q16 ulp = Q16::from_raw(1), half = 0.5_q16;
    static_assert(length(vec3(ulp, Q16{}, Q16{})) == ulp && length(vec2(3, 4)) == 5 && length(vec4(1, 1, 1, 1)) == 2);
    static_assert(normalize(vec3(ulp, Q16{}, Q16{})) == vec3(1, 0, 0) && normalize(vec4(-ulp)) == vec4(-half));
    static_assert(normalize(vec4(smallest)) == vec4(-half) && normalize(vec4(largest)) == vec4(half) && normalize(vec3(0)) == vec3(0));
    static_assert(normalize(vec2(smallest, Q16{})) == vec2(-1, 0) && length(vec4(smallest)) == largest && length(vec2(smallest, Q16{})) == largest);
    static_assert(distance(vec3(smallest), vec3(largest)) == largest && distance(vec2(1, 2), vec2(4, 6)) == 5);
    static_assert(dot(vec4(smallest), vec4(smallest)) == largest && dot(vec4(smallest), vec4(largest)) == smallest);
    static_assert(length(-3_q16) == 3 && distance(2_q16, 5_q16) == 3 && normalize(-0.25_q16) == -1 && dot(2_q16, 3_q16) == 6);
}

TEST(GlslGeometric, Cross) {
    Worst worst("cross");
    AnyNumber any(22);
    for (int i = 0; i < 500'000; ++i) {
        const vec3 a = any_vector<vec3>(any), b = any_vector<vec3>(any), c = cross(a, b);
        for (int k = 0; k < 3; ++k) {
            const int p = (k + 1) % 3, q = (k + 2) % 3;
            const long double exact = static_cast<long double>(a[p].raw) * b[q].raw - static_cast<long double>(a[q].raw) * b[p].raw;
            worst.add(c[k], static_cast<double>(exact / 65536 / 65536));
        }
    }
    worst.expect(cross_max_error);
    static_assert(cross(vec3(1, 0, 0), vec3(0, 1, 0)) == vec3(0, 0, 1));
}

template <class V>
void check_reflect(Worst& worst, Worst& relative) {
    AnyNumber any(23);
    for (int i = 0; i < 300'000; ++i) {
        const V incident = any_vector<V>(any), n = unit_vector<V>(any) * (i % 3 ? Q16::from_int(1) : fract(any()) + fract(any())), got = reflect(incident, n);
        const long double d = 2 * exact_dot(incident, n);
        for (int k = 0; k < V::size; ++k) {
            const long double multiple = d * wide(n[k]), exact = wide(incident[k]) - multiple;
            if (std::fabs(d) < 16) worst.add(got[k], static_cast<double>(exact));
            else relative.add_relative(got[k], static_cast<double>(exact), static_cast<double>(d));
        }
    }
}

TEST(GlslGeometric, Reflect) {
    Worst worst("reflect"), relative("reflect far");
    check_reflect<vec2>(worst, relative);
    check_reflect<vec3>(worst, relative);
    check_reflect<vec4>(worst, relative);
    worst.expect(reflect_max_error);
    relative.expect_relative(reflect_max_relative_error_log2);
    static_assert(reflect(vec2(1, -1), vec2(0, 1)) == vec2(1, 1) && reflect(vec3(0, 0, -32768), vec3(0, 0, 1)) == vec3(0, 0, largest));
}

template <class V>
void check_refract(Worst& worst) {
    AnyNumber any(24);
    for (int i = 0; i < 200'000; ++i) {
        const V incident = unit_vector<V>(any), n = unit_vector<V>(any);
        const long double d = exact_dot(incident, n), last = std::fmin(65536 / std::sqrt(std::fabs(1 - d * d)), 4 * 65536.0L);
        const auto choice = static_cast<int64_t>(any.bits() % (4 * 65536));
        const Q16 eta = Q16::from_raw(saturate(i % 2 ? choice : static_cast<int64_t>(last) - choice % 2));  // beside the critical angle
        const long double k = 1 - wide(eta) * wide(eta) * (1 - d * d);
        const V got = refract(incident, n, eta);
        for (int c = 0; c < V::size; ++c) {
            const long double exact = k < 0 ? 0 : wide(eta) * wide(incident[c]) - (wide(eta) * d + std::sqrt(k)) * wide(n[c]);
            worst.add(got[c], static_cast<double>(exact));
        }
    }
}

TEST(GlslGeometric, Refract) {
    Worst worst("refract");
    check_refract<vec2>(worst);
    check_refract<vec3>(worst);
    check_refract<vec4>(worst);
    worst.expect(refract_max_error);
    static_assert(refract(vec2(0, -1), vec2(0, 1), 0.75_q16) == vec2(0, -1));          // straight on
    static_assert(refract(vec2(0.8_q16, -0.6_q16), vec2(0, 1), 1.5_q16) == vec2(0));   // all is reflected
    static_assert(refract(vec3(0.6_q16, -0.8_q16, 0), vec3(0, 1, 0), 1) == vec3(0.6_q16, -0.8_q16, 0));
}

TEST(GlslGeometric, FaceforwardTurnsAgainstTheIncidentDirection) {
    constexpr vec3 n(0, 0, 1);
    static_assert(faceforward(n, vec3(0, 0, -1), n) == n && faceforward(n, vec3(0, 0, 1), n) == -n && faceforward(n, vec3(1, 0, 0), n) == -n);
}

}  // namespace
}  // namespace shade16::glsl
