// How a run of the bounds is shared: shards look at every input once, and what they found is put together.
#include <map>

#include <gmock/gmock.h>

#include "host_sim/bounds/result.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::bounds {
namespace {

using testing::HasSubstr;

constexpr uint64_t inputs = (uint64_t{5} << 24) + 7;  // five pieces and a rest

Entry any_entry() { return {.name = "any", .header = "", .functions = "", .unit = "units", .inputs = {3, inputs + 2}}; }

TEST(Bounds, shards_look_at_every_input_once) {
    std::map<uint64_t, uint64_t> pieces;  // first and last
    for (uint64_t shard = 0; shard < 3; ++shard)
        for (const Span& span : all_spans(any_entry(), {shard, 3})) {
            EXPECT_EQ(span.stride, 1u);
            EXPECT_TRUE(pieces.emplace(span.first, span.last).second);
        }
    uint64_t next = 3;
    for (const auto& [first, last] : pieces) {
        EXPECT_EQ(first, next);
        next = last + 1;
    }
    EXPECT_EQ(next, inputs + 3);
}

TEST(Bounds, an_ordinary_run_takes_both_ends_and_the_powers_of_two) {
    const auto is_taken = [spans = ordinary_spans(any_entry())](uint64_t input) {
        return std::any_of(spans.begin(), spans.end(), [input](const Span& s) {
            return s.first <= input && input <= s.last && (input - s.first) % s.stride == 0;
        });
    };
    EXPECT_TRUE(is_taken(3) && is_taken(inputs + 2));
    for (int bit = 0; bit < 26; ++bit) EXPECT_TRUE(is_taken(3 + (uint64_t{1} << bit))) << bit;
    EXPECT_FALSE(is_taken(2) || is_taken(inputs + 3));
}

TEST(Bounds, merging_keeps_the_largest_error_and_adds_the_inputs) {
    const auto found = [](double error, uint64_t at) { return result_of(any_entry(), {.error = error, .at = at, .inputs = 10}); };
    std::vector<Result> all{found(0.25, 5)};
    merge(all, {found(0.75, 17)}, "second");
    merge(all, {found(0.5, 29)}, "third");
    EXPECT_EQ(all[0].measured, 0.75);
    EXPECT_EQ(all[0].at, 17u);
    EXPECT_EQ(all[0].inputs, 30u);
    Result other = found(0, 0);
    other.bound = 7;
    EXPECT_THAT(host::complaint([&] { merge(all, {other}, "other.json"); }), HasSubstr("other.json: entry 0 is any"));
    EXPECT_THAT(host::complaint([&] { merge(all, {}, "none.json"); }), HasSubstr("none.json: holds 0 entries; expected 1"));
}

TEST(Bounds, an_error_that_is_no_number_is_the_largest) {
    Peak peak;
    for (const double error : {0.1, std::nan(""), 0.2}) peak.add(error, 7);
    EXPECT_GT(peak.error, 1e300);
    EXPECT_EQ(peak.inputs, 3u);
    EXPECT_TRUE(std::isnan(larger(std::nan(""), 1.0)) && std::isnan(larger(1.0, std::nan(""))));
}

}  // namespace
}  // namespace shade16::bounds
