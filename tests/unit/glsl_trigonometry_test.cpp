#include "shade16/glsl/trigonometry.hpp"

#include "unit/glsl_error.hpp"

namespace shade16::glsl {
namespace {

TEST(GlslTrigonometry, RadiansAndDegrees) {
    constexpr double pi = 3.14159265358979323846;
    Worst to("radians"), from("degrees");
    over_the_range([&](Q16 x) {
        to.add(radians(x), value(x) * pi / 180);
        from.add(degrees(x), value(x) * 180 / pi);
    });
    to.expect(radians_max_error);
    from.expect(degrees_max_error);
}

TEST(GlslTrigonometry, SineAndCosineOverTheWholeRange) {
    Worst sine("sin"), cosine("cos");
    over_the_range([&](Q16 x) {
        sine.add(sin(x), std::sin(value(x)));
        cosine.add(cos(x), std::cos(value(x)));
    });
    sine.expect(sin_max_error);
    cosine.expect(cos_max_error);
    static_assert(sin(0) == 0 && cos(0) == 1);
}

TEST(GlslTrigonometry, Tangent) {
    Worst small("tan < 256"), large("tan"), steep("tan steep");
    const auto check = [&](Q16 x) {
        const double exact = std::tan(value(x));
        if (std::fabs(exact) < 256) small.add(tan(x), exact);
        else if (std::fabs(exact) < 40'000) large.add_relative(tan(x), exact, exact);
        else steep.add(tan(x), exact);
    };
    over_the_range(check);
    for (int pole = -10'000; pole < 10'000; ++pole) {  // the numbers beside every pole
        const auto raw = static_cast<int64_t>(std::llround((pole + 0.5) * 3.14159265358979323846 * 65536));
        for (int64_t near = -3; near <= 3; ++near) check(Q16::from_raw(saturate(raw + near)));
    }
    small.expect(tan_max_error);
    large.expect_relative(tan_max_relative_error_log2);
    steep.expect(0_ulps);
}

TEST(GlslTrigonometry, ArcusFunctions) {
    Worst sine("asin"), cosine("acos"), tangent("atan");
    for (int32_t raw = -65'536; raw <= 65'536; ++raw) {
        sine.add(asin(Q16::from_raw(raw)), std::asin(raw / 65536.0));
        cosine.add(acos(Q16::from_raw(raw)), std::acos(raw / 65536.0));
    }
    over_the_range([&](Q16 x) { tangent.add(atan(x), std::atan(value(x))); });
    sine.expect(asin_max_error);
    cosine.expect(acos_max_error);
    tangent.expect(atan_max_error);
}

TEST(GlslTrigonometry, ArcusTangentOfTwoArguments) {
    Worst worst("atan(y, x)");
    AnyNumber any(5);
    for (int i = 0; i < 1'000'000; ++i) {
        const Q16 y = any(), x = any();
        worst.add(atan(y, x), y.raw == 0 ? (x.raw < 0 ? std::atan2(0.0, -1.0) : 0) : std::atan2(value(y), value(x)));
    }
    worst.expect(atan_max_error);
    static_assert(atan(0, 0) == 0 && atan(0, 5) == 0 && atan(0, -5) == 3.14159265_q16);
    static_assert(atan(-32768, -32768) == -2.35619449_q16 && atan(1, 0) == 1.57079633_q16);
}

TEST(GlslTrigonometry, OutsideTheDomainTheNearestEndCounts) {
    static_assert(asin(2) == asin(1) && asin(-32768) == asin(-1) && asin(1) == 1.57079633_q16);
    static_assert(acos(1.5_q16) == 0 && acos(1) == 0 && acos(-7) == acos(-1) && acos(-1) == 3.14159265_q16);
    static_assert(degrees(32767) == Q16::from_raw(INT32_MAX) && degrees(-32768) == -32768);
}

TEST(GlslTrigonometry, OfVectorsIsByComponent) {
    constexpr vec4 v(0, 1, -2, 300);
    static_assert(sin(v) == vec4(sin(v.x), sin(v.y), sin(v.z), sin(v.w)));
    static_assert(cos(v.xy()) == vec2(1, cos(1)) && tan(v.zyx()) == vec3(tan(-2), tan(1), 0));
    static_assert(asin(v).y == asin(1) && acos(v).z == acos(-1) && atan(v).w == atan(300));
    static_assert(atan(vec2(1, 2), vec2(3, -4)) == vec2(atan(1, 3), atan(2, -4)));
    static_assert(radians(vec2(180, 90)) == vec2(3.14159265_q16, 1.57079633_q16) && degrees(vec3(0)) == vec3(0));
}

}  // namespace
}  // namespace shade16::glsl
