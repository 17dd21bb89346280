#include "shade16/num/block.hpp"

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "host_sim/bounds/relative.hpp"

namespace shade16::bounds {
namespace {

long double wide_block(Block b) { return std::ldexp(static_cast<long double>(b.mantissa), b.exponent); }

Block any_block(Dice& dice) {
    const int64_t mantissa = dice.long_number();
    return {std::max(mantissa, INT64_MIN + 1), dice.integer(-60, 60)};
}

double share_of(long double error, long double size) {
    return static_cast<double>(size == 0 ? std::fabs(error) : std::fabs(error / size));
}

double shortened_error(Dice& dice) {
    const Block b = any_block(dice), s = b.shortened();
    if (s.mantissa > INT64_C(0x80000000) || s.mantissa < -INT64_C(0x80000000)) return 1;
    return share_of(wide_block(s) - wide_block(b), wide_block(b));
}

double top_error(Dice& dice) {
    const Block b = any_block(dice);
    const long double size = std::fabs(wide_block(b));
    if (b.mantissa == 0) return b.top() <= -1000 ? 0 : 1;
    return size < std::ldexp(1.0L, b.top()) && std::ldexp(1.0L, b.top() - 1) <= size ? 0 : 1;
}

double units_error(Dice& dice) {
    const Block b = any_block(dice);
    const int unit = b.top() - dice.integer(-4, 40);
    const long double exact = std::clamp<long double>(std::ldexp(wide_block(b), -unit), INT32_MIN, INT32_MAX);
    return static_cast<double>(std::fabs(b.in_units_of(unit) - exact));
}

double product_error(Dice& dice) {
    const Block a = any_block(dice);
    const Scaled k{dice.mantissa(), dice.integer(-60, 60)};
    return share_of(wide_block(a * k) - wide_block(a) * wide(k), wide_block(a) * wide(k));
}

/// In shares of the larger operand.
double sum_error(Dice& dice) {
    const Block a = any_block(dice), b = any_block(dice);
    const long double x = wide_block(a), y = wide_block(b), size = std::fmax(std::fabs(x), std::fabs(y));
    // The larger one goes first, so that the reference rounds what is small.
    const auto left = [x, y](Block got, long double sign) {
        const long double s = wide_block(got);
        return std::fabs(x) > std::fabs(y) ? s - x - sign * y : s - sign * y - x;
    };
    return larger(share_of(left(a + b, 1), size), share_of(left(a - b, -1), size));
}

BlockVector any_block_vector(Dice& dice) { return {any_block(dice), any_block(dice), any_block(dice)}; }
long double largest(const BlockVector& v) {
    return std::fmax(std::fabs(wide_block(v.x)), std::fmax(std::fabs(wide_block(v.y)), std::fabs(wide_block(v.z))));
}

double vector_error(Dice& dice) {
    const BlockVector a = any_block_vector(dice), b = any_block_vector(dice), sum = a + b, difference = a - b;
    const Scaled k{dice.mantissa(), dice.integer(-60, 60)};
    const BlockVector product = a * k;
    const Vec3 p = dice.vec3(), q = dice.vec3();
    const BlockVector exact = component_product(p, q), same = as_block(p);
    const IVec3 units = a.in_units_of(a.top() - 30);
    Differences wrong;
    const auto equal = [&](Block x, Block y) { wrong(x.mantissa, y.mantissa)(x.exponent, y.exponent); };
    equal(sum.x, a.x + b.x), equal(sum.y, a.y + b.y), equal(sum.z, a.z + b.z);
    equal(difference.x, a.x - b.x), equal(difference.y, a.y - b.y), equal(difference.z, a.z - b.z);
    equal(product.x, a.x * k), equal(product.y, a.y * k), equal(product.z, a.z * k);
    equal(exact.x, {int64_t{p.x.raw} * q.x.raw, -32}), equal(exact.y, {int64_t{p.y.raw} * q.y.raw, -32}),
        equal(exact.z, {int64_t{p.z.raw} * q.z.raw, -32});
    equal(same.x, {p.x.raw, -16}), equal(same.y, {p.y.raw, -16}), equal(same.z, {p.z.raw, -16});
    wrong(units.x, a.x.in_units_of(a.top() - 30))(units.y, a.y.in_units_of(a.top() - 30))(
        units.z, a.z.in_units_of(a.top() - 30));
    return wrong(a.top(), std::max({a.x.top(), a.y.top(), a.z.top()}));
}

double rotated_error(Dice& dice) {
    const Mat3 m = dice.rotation();
    const BlockVector v = any_block_vector(dice), got = m * v;
    const auto exact = [&](const Normal30& r) {
        return (r.x.raw * wide_block(v.x) + r.y.raw * wide_block(v.y) + r.z.raw * wide_block(v.z)) * 0x1p-30L;
    };
    const long double size = largest(v);
    return larger(share_of(wide_block(got.x) - exact(m.row[0]), size),
                  larger(share_of(wide_block(got.y) - exact(m.row[1]), size),
                         share_of(wide_block(got.z) - exact(m.row[2]), size)));
}

}  // namespace

void add_blocks(Entries& to) {
    const auto entry = [](const char* name, const char* functions, const char* unit, double bound) {
        return Entry{.name = name, .header = "num/block.hpp", .functions = functions, .unit = unit, .bound = bound};
    };
    to.add_random(
        entry("Block::shortened", "Block::shortened", "of it", std::ldexp(1.0, block_shortened_max_error_log2)),
        shortened_error);
    to.add_random(entry("Block::top", "Block::top", "wrong results", 0), top_error);
    to.add_random(entry("Block::in_units_of", "Block::in_units_of", "units", in_ulps(block_units_max_error)),
                  units_error);
    to.add_random(entry("Block product", "Block::operator*", "of it", std::ldexp(1.0, block_product_max_error_log2)),
                  product_error);
    to.add_random(entry("Block sum", "Block::operator+ Block::operator-", "of the larger operand",
                        std::ldexp(1.0, block_sum_max_error_log2)),
                  sum_error);
    to.add_random(entry("BlockVector",
                        "BlockVector::top BlockVector::in_units_of BlockVector::operator+ BlockVector::operator- "
                        "BlockVector::operator* as_block component_product",
                        "units, from Block", 0),
                  vector_error);
    to.add_random(entry("Mat3 times BlockVector", "operator*", "of the largest component",
                        std::ldexp(1.0, block_rotation_max_error_log2)),
                  rotated_error);
}

}  // namespace shade16::bounds
