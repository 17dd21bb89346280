// The numbers of the proofs, as the headers have them: `name=value`, where 259b-32 is 259 * 2^-32 to Gappa. Those that a proof
// claims are printed at their value, or, as the second argument asks, at half of it.
// usage: print_numbers <tier> <full | half>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "shade16/pipeline/light.hpp"
#include "shade16/pipeline/vertex.hpp"

namespace {

using namespace shade16;

/// The largest entry of a table is the largest value of its lines.
template <class Table>
unsigned largest_entry(const Table& table) {
    unsigned largest = 0;
    for (const unsigned entry : table.y) largest = max(largest, entry);
    return largest;
}

void print_claim(const char* name, unsigned long long mantissa, int exponent, int lowered_bits) {
    std::printf("%s=%llub%d\n", name, mantissa, exponent);
    std::printf("CLAIMED_%s=%llub%d\n", name, mantissa, exponent - lowered_bits);
}

template <class Tier>
void print_numbers(int lowered_bits) {
    print_claim("q16_product_max_error", q16_product_max_error.milli * 65536 / 1000, -32, lowered_bits);
    print_claim("rsqrt_newton_max_error", rsqrt_newton_max_error, -32, lowered_bits);
    print_claim("reciprocal_max_error", reciprocal_max_error, -32, lowered_bits);
    print_claim("light_term_max_error", light_term_max_error<Tier>, -32, lowered_bits);
    print_claim("color_sum_max_error", color_sum_max_error<Tier>, -32, lowered_bits);

    // A promise in units of 2^-32 of full scale, of which a level is 1/255; rounded down.
    const unsigned long long promise = (uint64_t{Tier::promise.to_exponent_128.micro} << 32) / 255'000'000;
    std::printf("promise=%llub-32\n", promise);
    std::printf("promise_without_sum=%llub-32\n", promise - color_sum_max_error<Tier>);

    std::printf("rsqrt_49_max_error=%lub-32\n", static_cast<unsigned long>(rsqrt_49_max_error));
    std::printf("rsqrt_linear_largest=%ub-16\n", largest_entry(detail::rsqrt_table_49));
    std::printf("reciprocal_linear_max_error=%lub-32\n", static_cast<unsigned long>(reciprocal_linear_max_error));
    std::printf("reciprocal_linear_largest=%ub-16\n", largest_entry(detail::reciprocal_table));
    std::printf("largest_q32=%lub-32\n", static_cast<unsigned long>(UINT32_MAX));
    std::printf("near_one=%lub-32\n", static_cast<unsigned long>(UINT32_MAX - 7));  // where the proofs of a word's end part
    std::printf("tier=%s\n", Tier::name);
    std::printf("mantissa_bits=%d\n", Arithmetic<Tier>::wide ? 32 : 16);
    std::printf("channel_bits=%d\n", ScreenVertex<Tier>::channel_bits);
}

}  // namespace

int main(int count, char** words) {
    const std::string_view tier = count == 3 ? words[1] : "", claim = count == 3 ? words[2] : "";
    const int lowered_bits = claim == "full" ? 0 : claim == "half" ? 1 : -1;
    if (lowered_bits >= 0 && tier == lowp::name) return print_numbers<lowp>(lowered_bits), EXIT_SUCCESS;
    if (lowered_bits >= 0 && tier == mediump::name) return print_numbers<mediump>(lowered_bits), EXIT_SUCCESS;
    if (lowered_bits >= 0 && tier == highp::name) return print_numbers<highp>(lowered_bits), EXIT_SUCCESS;
    std::fputs("usage: print_numbers <lowp | mediump | highp> <full | half>\n", stderr);
    return EXIT_FAILURE;
}
