// A need decides which code exists, never which arithmetic runs: whatever draws a scene draws the same bits.
#include <array>
#include <cstdio>
#include <optional>

#include <gtest/gtest.h>

#include "accuracy/random_scene.hpp"
#include "host_sim/report/terms.hpp"
#include "tests/pairwise/rows.hpp"

namespace shade16::host {
namespace {

constexpr Viewport frame_size{48, 36};
constexpr int scenes_a_row = 30;

std::size_t term_count(const Needs& n) {
    std::size_t sum = 0;
    for (const Term& t : terms) sum += n.*t.is_needed;
    return sum;
}

using Draw = std::vector<uint16_t> (*)(const Scene&, Viewport);
template <std::size_t... Row>
constexpr std::array<Draw, sizeof...(Row)> draws_of(std::index_sequence<Row...>) {
    return {pairwise::draw<Row>...};
}
constexpr auto draws = draws_of(std::make_index_sequence<pairwise::row_count>());

/// The row of fewest terms that covers a scene.
std::optional<std::size_t> smallest_cover(const Needs& want) {
    std::optional<std::size_t> best;
    for (std::size_t r = 0; r < pairwise::row_count; ++r)
        if (covers(pairwise::rows[r], want) && (!best || term_count(pairwise::rows[r]) < term_count(pairwise::rows[*best]))) best = r;
    return best;
}

std::vector<uint16_t> by_all_terms(const Scene& scene, bool depth) {
    return (depth ? pairwise::draw<pairwise::row_count + 1> : pairwise::draw<pairwise::row_count>)(scene, frame_size);
}

class Pairwise : public testing::TestWithParam<std::size_t> {};

TEST_P(Pairwise, TheSmallestCoverDrawsTheBitsOfAllTerms) {
    const std::size_t r = GetParam();
    Needs used;
    std::size_t shown = 0;
    for (int i = 0; i < scenes_a_row; ++i) {
        Random random(5000 + 100 * r + static_cast<std::size_t>(i));
        const RandomScene random_scene(random, pairwise::rows[r]);
        const Scene& scene = random_scene.scene();
        const Needs want = needs_of(scene);
        ASSERT_TRUE(covers(pairwise::rows[r], want)) << "scene " << i << " uses a term that it may not";
        const std::size_t cover = *smallest_cover(want);
        const auto all = by_all_terms(scene, pairwise::rows[r].depth);
        EXPECT_EQ(draws[cover](scene, frame_size), by_all_terms(scene, pairwise::rows[cover].depth)) << "scene " << i << ", drawn by row " << cover;
        EXPECT_EQ(draws[r](scene, frame_size), all) << "scene " << i << ", drawn by its own row";
        used = used | want;
        const auto background = nearest_pixel<Rgb565>(scene.background);
        shown += std::any_of(all.begin(), all.end(), [&](uint16_t p) { return p != background; });
    }
    EXPECT_GE(shown, static_cast<std::size_t>(scenes_a_row) / 2) << "empty frames are equal, too";
    for (const Term& term : terms) EXPECT_EQ(used.*term.is_needed, pairwise::rows[r].*term.is_needed) << term.name << " is in no scene";
}
INSTANTIATE_TEST_SUITE_P(, Pairwise, testing::Range(std::size_t{0}, pairwise::row_count));

/// Whether terms ask for each other so that no pipeline has this combination.
bool is_possible(const Term& a, bool has_a, const Term& b, bool has_b) {
    Needs with;
    if (has_a) with.*a.is_needed = true;
    if (has_b) with.*b.is_needed = true;
    with = pairwise::closed(with);
    return with.*a.is_needed == has_a && with.*b.is_needed == has_b;
}

TEST(PairwiseRows, HoldEveryPairOfTerms) {
    std::size_t possible = 0, missing = 0;
    for (const Term& a : terms)
        for (const Term& b : terms)
            for (const bool has_a : {false, true})
                for (const bool has_b : {false, true}) {
                    if (&a >= &b || !is_possible(a, has_a, b, has_b)) continue;
                    ++possible;
                    bool found = false;
                    for (std::size_t r = 0; r < pairwise::row_count; ++r)
                        found = found || (pairwise::rows[r].*a.is_needed == has_a && pairwise::rows[r].*b.is_needed == has_b);
                    missing += !found;
                    if (!found) std::printf("no row has %s %d and %s %d\n", a.name, has_a, b.name, has_b);
                }
    std::printf("[ rows     ] %zu combinations of two terms are possible, %zu in no row\n", possible, missing);
    EXPECT_EQ(missing, 0u) << "run find_rows.cpp, and put its rows into rows.hpp";
}

}  // namespace
}  // namespace shade16::host
