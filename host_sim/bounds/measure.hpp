// How much of a domain a run looks at.
#pragma once

#include <functional>
#include <vector>

#include "host_sim/bounds/entry.hpp"
#include "host_sim/bounds/shard.hpp"

namespace shade16::bounds {

/// What an ordinary run measures of a function of one argument: every input of a small domain; of a large one those
/// around every power of two, counted from both ends, and around a hundred places in between, and four million spread
/// evenly. Of random cases it takes a million.
std::vector<Span> ordinary_spans(const Entry& entry);

/// All inputs, in pieces of equal length, of which a shard takes every of-th.
std::vector<Span> all_spans(const Entry& entry, Shard shard);

/// The largest error over the spans; `progress` is told how many of them are done.
Peak measure(const Entry& entry, const std::vector<Span>& spans, const std::function<void(std::size_t)>& progress = {});

}  // namespace shade16::bounds
