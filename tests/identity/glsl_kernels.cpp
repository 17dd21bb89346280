// GLSL's functions.
#include "shade16/glsl.hpp"

#include "tests/identity/kernels.hpp"

namespace shade16::identity {

namespace {

void run_common(const KernelRun& run) {
    run("whole_numbers", [](Numbers& n) {
        const Q16 x = n.q16();
        return Both{Both{glsl::floor(x), glsl::ceil(x)}, Both{glsl::trunc(x), glsl::fract(x)}};
    });
    run("abs_and_sign", [](Numbers& n) { const Q16 x = n.q16(); return Both{glsl::abs(x), glsl::sign(x)}; });
    run("mod", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return glsl::mod(x.a, x.b); });
    run("divide", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return glsl::divide(x.a, x.b); });
    run("mix", [](Numbers& n) { const Vec3 x = n.vec3(); return Both{glsl::mix(x.x, x.y, x.z), glsl::mix(x.x, x.y, n.share())}; });
    run("smoothstep", [](Numbers& n) { const Vec3 x = n.vec3(); return glsl::smoothstep(x.x, x.y, x.z); });
}

void run_exponential(const KernelRun& run) {
    run("sqrt", [](Numbers& n) { return glsl::sqrt(n.q16()); });
    run("inversesqrt", [](Numbers& n) { return glsl::inversesqrt(n.q16()); });
    run("exp2", [](Numbers& n) { return glsl::exp2(n.q16()); }, Pace::slow);
    run("log2", [](Numbers& n) { return glsl::log2(n.q16()); }, Pace::slow);
    run("exp", [](Numbers& n) { return glsl::exp(n.q16()); }, Pace::slow);
    run("log", [](Numbers& n) { return glsl::log(n.q16()); }, Pace::slow);
    run("pow", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return glsl::pow(x.a, x.b); }, Pace::slow);
}

void run_trigonometry(const KernelRun& run) {
    run("radians_and_degrees", [](Numbers& n) { const Q16 x = n.q16(); return Both{glsl::radians(x), glsl::degrees(x)}; });
    run("sin_and_cos", [](Numbers& n) { const Q16 x = n.q16(); return Both{glsl::sin(x), glsl::cos(x)}; });
    run("tan", [](Numbers& n) { return glsl::tan(n.q16()); });
    run("asin", [](Numbers& n) { return glsl::asin(n.q16()); });
    run("acos", [](Numbers& n) { return glsl::acos(n.q16()); });
    run("atan", [](Numbers& n) { const Both x{n.q16(), n.q16()}; return glsl::atan(x.a, x.b); });
}

void run_geometric(const KernelRun& run) {
    const auto vec3 = [](Numbers& n) { return glsl::vec3{n.q16(), n.q16(), n.q16()}; };
    const auto plain = [](const glsl::vec3& v) { return Vec3(v); };

    run("length", [=](Numbers& n) { return glsl::length(vec3(n)); });
    run("normalize", [=](Numbers& n) { return plain(glsl::normalize(vec3(n))); });
    run("dot", [=](Numbers& n) { const Both v{vec3(n), vec3(n)}; return glsl::dot(v.a, v.b); });
    run("cross", [=](Numbers& n) { const Both v{vec3(n), vec3(n)}; return plain(glsl::cross(v.a, v.b)); });
    run("reflect", [=](Numbers& n) { const Both v{vec3(n), glsl::normalize(vec3(n))}; return plain(glsl::reflect(v.a, v.b)); }, Pace::slow);
    run("refract", [=](Numbers& n) {
        const Both v{glsl::normalize(vec3(n)), glsl::normalize(vec3(n))};
        return plain(glsl::refract(v.a, v.b, n.q16()));
    }, Pace::slow);
    run("faceforward", [=](Numbers& n) { const Both v{vec3(n), vec3(n)}; return plain(glsl::faceforward(v.a, v.b, v.a)); });
    run("matrix_times_vector", [=](Numbers& n) { const Both v{vec3(n), vec3(n)}; return plain(glsl::mat3(v.a, v.b, v.a + v.b) * v.a); });
}

}  // namespace

void say_glsl_kernels(Inputs inputs) {
    const KernelRun run("glsl", inputs);
    run_common(run), run_exponential(run), run_trigonometry(run), run_geometric(run);
}

}  // namespace shade16::identity
