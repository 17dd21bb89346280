#include "host_sim/bounds/measure.hpp"

#include <algorithm>

namespace shade16::bounds {
namespace {

constexpr uint64_t ordinary_inputs = 4'000'000, ordinary_cases = 1'000'000, near = 500, places = 128;

uint64_t size_less_one(const Span& s) { return s.last - s.first; }

/// The inputs within `near` of a place.
Span around(const Span& all, uint64_t place) {
    return {std::max(all.first, place < near ? 0 : place - near), std::min(all.last, place + near)};
}

}  // namespace

std::vector<Span> ordinary_spans(const Entry& entry) {
    const Span all = entry.inputs;
    if (entry.domain == Domain::random_cases) return {{all.first, std::min(all.last, all.first + ordinary_cases - 1)}};
    if (size_less_one(all) < 2 * ordinary_inputs) return {all};
    std::vector<Span> spans;
    for (uint64_t distance = 1; distance < size_less_one(all); distance *= 2)
        for (const uint64_t place : {all.first + distance, all.last - distance}) spans.push_back(around(all, place));
    const uint64_t apart = size_less_one(all) / places + 1;
    for (uint64_t i = 1; i < places; ++i) spans.push_back(around(all, all.first + i * apart));
    spans.push_back({all.first, all.last, size_less_one(all) / ordinary_inputs | 1});
    return spans;
}

std::vector<Span> all_spans(const Entry& entry, Shard shard) {
    constexpr uint64_t piece = uint64_t{1} << 24;
    const Span all = entry.inputs;
    std::vector<Span> spans;
    for (uint64_t i = shard.number; i <= size_less_one(all) / piece; i += shard.of) {
        const uint64_t first = all.first + i * piece;
        spans.push_back({first, all.last - first < piece ? all.last : first + piece - 1});
    }
    return spans;
}

Peak measure(const Entry& entry, const std::vector<Span>& spans, const std::function<void(std::size_t)>& progress) {
    Peak peak;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        peak.add(entry.measure(spans[i]));
        if (progress) progress(i + 1);
    }
    return peak;
}

}  // namespace shade16::bounds
