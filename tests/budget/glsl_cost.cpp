// Calls each function of GLSL's vocabulary for sixteen arguments, between marks of its own: scripts/bench.sh --glsl counts
// the instructions in between.
#include "shade16/glsl.hpp"

using namespace shade16;
using namespace shade16::glsl;

// Volatile, so that the compiler cannot work the answers out beforehand.
static volatile int32_t numbers[16] = {1, 77, 1500, 30'000, 60'000, 65'536, 70'000, 100'000,
                                       150'000, 200'000, 300'000, 400'000, 500'000, 555'555, 600'000, 655'360};
static volatile int32_t sum;

static Q16 number(int i) { return Q16::from_raw(numbers[i & 15]); }
static vec3 vector(int i) { return vec3(number(i), -number(i + 5), number(i + 9)); }
static void use(Q16 x) { sum = sum + x.raw; }
static void use(const vec3& v) { use(Q16::from_raw(v.x.raw ^ v.y.raw ^ v.z.raw)); }
static void use(const vec4& v) { use(v.xyz()), use(v.w); }

#define MEASURE(name, argument, result)                                                     \
    extern "C" __attribute__((noinline, used)) void begin_##name() { asm volatile("" ::: "memory"); } \
    extern "C" __attribute__((noinline, used)) void end_##name() { asm volatile("" ::: "memory"); }   \
    __attribute__((noinline)) static void measure_##name() {                                \
        begin_##name();                                                                     \
        for (int i = 0; i < 16; ++i) {                                                      \
            const auto x = argument;                                                        \
            use(result);                                                                    \
        }                                                                                   \
        end_##name();                                                                       \
    }

MEASURE(number, number(i), x)  // the loop itself, which is subtracted
MEASURE(vector, vector(i), x)
MEASURE(mod, number(i), mod(x, 3))
MEASURE(divide, number(i), divide(1, x))
MEASURE(mix, number(i), mix(x, 2, x))
MEASURE(smoothstep, number(i), smoothstep(0, 10, x))
MEASURE(sqrt, number(i), sqrt(x))
MEASURE(inversesqrt, number(i), inversesqrt(x))
MEASURE(exp2, number(i), exp2(x))
MEASURE(exp, number(i), exp(x))
MEASURE(log2, number(i), log2(x))
MEASURE(log, number(i), log(x))
MEASURE(pow, number(i), pow(x, 2.2_q16))
MEASURE(radians, number(i), radians(x))
MEASURE(sin, number(i), sin(x))
MEASURE(tan, number(i), tan(x))
MEASURE(acos, number(i), acos(fract(x)))
MEASURE(atan, number(i), atan(x))
MEASURE(dot, vector(i), vec3(dot(x, x), Q16{}, Q16{}))
MEASURE(cross, vector(i), cross(x, vec3(1, 2, 3)))
MEASURE(length, vector(i), vec3(length(x), Q16{}, Q16{}))
MEASURE(normalize, vector(i), normalize(x))
MEASURE(reflect, vector(i), reflect(x, vec3(0, 0.6_q16, 0.8_q16)))
MEASURE(refract, vector(i), refract(x, vec3(0, 0.6_q16, 0.8_q16), 0.75_q16))
MEASURE(mat3_vec3, vector(i), mat3(x, x, x) * x)
MEASURE(mat4_vec4, vector(i), mat4(vec4(x, 1), vec4(x, 1), vec4(x, 1), vec4(x, 1)) * vec4(x, 1))

int main() {
    measure_number(), measure_vector(), measure_mod(), measure_divide(), measure_mix(), measure_smoothstep(), measure_sqrt();
    measure_inversesqrt(), measure_exp2(), measure_exp(), measure_log2(), measure_log(), measure_pow(), measure_radians();
    measure_sin(), measure_tan(), measure_acos(), measure_atan(), measure_dot(), measure_cross(), measure_length();
    measure_normalize(), measure_reflect(), measure_refract(), measure_mat3_vec3(), measure_mat4_vec4();
    return 0;
}
