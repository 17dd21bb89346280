// Searches rows for rows.hpp, and prints them: c++ -std=c++20 -I core/include -I . tests/pairwise/find_rows.cpp -o find_rows && ./find_rows
// To be run again when there is a new term: the test says when a pair is in no row.
#include <cstdio>
#include <random>

#include "host_sim/report/terms.hpp"
#include "tests/pairwise/rows.hpp"

using namespace shade16;

namespace {
constexpr std::size_t count = detail::NeedsArray::count;

bool has(const Needs& n, std::size_t term) { return detail::as_array(n).term[term]; }
Needs with(std::size_t a, bool has_a, std::size_t b, bool has_b) {
    detail::NeedsArray terms{};
    terms.term[a] = has_a, terms.term[b] = has_b;
    return pairwise::closed(detail::as_needs(terms));
}
}  // namespace

int main() {
    bool open[count][count][2][2]{};  // combinations that no row has yet
    std::size_t left = 0;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (int p = 0; p < 2; ++p)
                for (int q = 0; q < 2; ++q) {
                    const Needs n = with(a, p, b, q);
                    open[a][b][p][q] = has(n, a) == p && has(n, b) == q;
                    left += open[a][b][p][q];
                }
    std::mt19937 random(1);
    while (left > 0) {
        Needs best;
        std::size_t most = 0;
        for (int attempt = 0; attempt < 20000; ++attempt) {
            detail::NeedsArray terms{};
            const unsigned share = 1 + random() % 12;
            for (bool& term : terms.term) term = random() % 16 < share;
            const Needs n = pairwise::closed(detail::as_needs(terms));
            std::size_t gain = 0;
            for (std::size_t a = 0; a < count; ++a)
                for (std::size_t b = 0; b < a; ++b) gain += open[a][b][has(n, a)][has(n, b)];
            if (gain > most) most = gain, best = n;
        }
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = 0; b < a; ++b) open[a][b][has(best, a)][has(best, b)] = false;
        left -= most;
        std::printf("    {");
        bool is_first = true;
        for (const host::Term& term : host::terms) {
            if (!(best.*term.is_needed)) continue;
            std::printf("%s.%s = true", is_first ? "" : ", ", term.name);
            is_first = false;
        }
        std::printf("},\n");
    }
}
