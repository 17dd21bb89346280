// The kernels of core/num on vectors: normalize, sines and arcs, rotations, blocks.
#include "shade16/num/arc.hpp"
#include "shade16/num/block.hpp"
#include "shade16/num/mat.hpp"
#include "shade16/pipeline/chord.hpp"

#include "tests/identity/kernels.hpp"

namespace shade16::identity {

namespace {

void run_vectors(const KernelRun& run) {
    run("normalize14_6", [](Numbers& n) { return normalize14<6>(n.ivec3()); });
    run("normalize14_7", [](Numbers& n) { return normalize14<7>(n.ivec3()); });
    run("normalize30", [](Numbers& n) { return normalize30(n.ivec3()); });
    run("normalize_finely", [](Numbers& n) { return normalize_finely(n.ivec3()); });
    run("dot14", [](Numbers& n) { const Both x{n.unit14(), n.unit14()}; return dot(x.a, x.b); });
    run("dot30", [](Numbers& n) { const Both x{n.unit30(), n.unit30()}; return dot(x.a, x.b); });
    run("dot_q16", [](Numbers& n) { const Both x{n.vec3(), n.vec3()}; return dot(x.a, x.b); });
    run("cross_q16", [](Numbers& n) { const Both x{n.vec3(), n.vec3()}; return cross(x.a, x.b); });
}

void run_chords(const KernelRun& run) {
    run("chord14", [](Numbers& n) { const Both x{n.unit14(), n.unit14()}; return detail::chord(x.a, x.b); });
    run("chord30", [](Numbers& n) { const Both x{n.unit30(), n.unit30()}; return detail::chord(x.a, x.b); });
}

void run_angles(const KernelRun& run) {
    run("sincos", [](Numbers& n) { return sincos(n.angle()); });
    run("arctangent", [](Numbers& n) {
        const SinCos unit = sincos(n.angle().half());  // of the upper half plane
        return arctangent(unit.sin, unit.cos);
    });
    run("arc", [](Numbers& n) {
        const Both ends{n.unit30(), n.unit30()};
        const Arc arc(ends.a, ends.b);
        return Both{arc.angle(), arc.at(static_cast<int32_t>(n.bits() >> 2))};
    }, Pace::slow);
    run("arc_between_neighbours", [](Numbers& n) {
        const Normal30 a = n.unit30();
        const IVec3 beside{a.x.raw + static_cast<int32_t>(n.below(256)), a.y.raw, a.z.raw - static_cast<int32_t>(n.below(256))};
        const Normal30 b = normalize_finely(beside);
        const Arc arc(a, n.below(2) == 0 ? b : Normal30{-b.x, -b.y, -b.z});
        return Both{arc.angle(), arc.at(static_cast<int32_t>(n.bits() >> 2))};
    }, Pace::slow);
}

void run_matrices(const KernelRun& run) {
    const auto rotation = [](Numbers& n) {
        const Both angles{n.angle(), n.angle()};
        return rotate_x(angles.a) * rotate_y(angles.b);
    };
    run("matrix_product", [=](Numbers& n) {
        const Mat3 m = rotation(n);
        return rotate_z(n.angle()) * m;
    }, Pace::slow);
    run("rotate", [=](Numbers& n) {
        const Mat3 m = rotation(n);
        const IVec3 v = n.ivec3();
        return rotate(m, v, static_cast<int>(n.below(9)));
    }, Pace::slow);
    run("rigid_transform", [=](Numbers& n) {
        const Mat3 m = rotation(n);
        const Mat3x4 there{m, n.vec3()};
        const Vec3 moved = there * n.vec3();
        return Both{moved, inverse(there) * moved};
    }, Pace::slow);
}

void run_blocks(const KernelRun& run) {
    const auto block = [](Numbers& n) { return Block{n.any_signed64(), static_cast<int>(n.below(128)) - 64}; };
    const auto short_block = [=](Numbers& n) { return block(n).shortened(); };

    run("block_shortened", short_block);
    run("block_sum", [=](Numbers& n) { const Both x{short_block(n), short_block(n)}; return Both{x.a + x.b, x.a - x.b}; });
    run("block_product", [=](Numbers& n) { const Both x{block(n), n.scaled()}; return x.a * x.b; });
    run("block_in_units", [=](Numbers& n) { const Both x{block(n), n.below(160)}; return x.a.in_units_of(static_cast<int>(x.b) - 80); });
    run("component_product", [](Numbers& n) { const Both x{n.vec3(), n.vec3()}; return component_product(x.a, x.b); });
    run("block_vector_rotated", [=](Numbers& n) {
        const Mat3 m = rotate_x(n.angle());
        return m * BlockVector{short_block(n), short_block(n), short_block(n)};
    });
}

}  // namespace

void say_vector_kernels(Inputs inputs) {
    const KernelRun run("vector", inputs);
    run_vectors(run), run_chords(run), run_angles(run), run_matrices(run), run_blocks(run);
}

}  // namespace shade16::identity
