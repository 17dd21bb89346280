#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/mulhi.hpp"

namespace shade16::bounds {
namespace {

constexpr int64_t high_word(int64_t x) { return x >> 32; }

double products(Dice& dice) {
    const uint32_t a = dice.word(), b = dice.word();
    const int32_t c = dice.number(), d = dice.number();
    const uint64_t e = dice.long_word(), f = dice.long_word();
    const int64_t cd = int64_t{c} * d, cb = int64_t{c} * b;
    const uint64_t ab = uint64_t{a} * b;
    Differences worst;
    worst(multiply(a, b), ab)(multiply(c, d), cd)(multiply(c, b), cb);
    worst(mulhi(a, b), ab >> 32)(mulhi(c, d), high_word(cd))(mulhi(c, b), high_word(cb));
    worst(narrow::multiply(a, b), ab)(narrow::multiply(c, d), cd)(narrow::multiply(c, b), cb);
    worst(narrow::mulhi(a, b), ab >> 32)(narrow::mulhi(c, d), high_word(cd))(narrow::mulhi(c, b), high_word(cb));
    return worst(mulhi(e, f), static_cast<uint64_t>(WideUnsigned{e} * f >> 64));
}

}  // namespace

void add_multiplies(Entries& to) {
    to.add_random(
        {.name = "multiply, mulhi", .header = "num/mulhi.hpp", .functions = "multiply mulhi", .unit = "units"},
        products);
}

}  // namespace shade16::bounds
