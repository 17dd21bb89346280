// What was found of an entry: the rows of bounds.json.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bounds/measure.hpp"

namespace shade16::bounds {

struct Result {
    std::string name{}, header{}, functions{}, unit{}, tier{};
    double bound = 0, measured = 0;
    uint64_t at = 0;      // the number of the worst input
    uint64_t inputs = 0;  // how many were looked at
    uint64_t of = 0;      // how many there are; 0 for random cases and searches

    bool holds() const { return measured <= bound; }
    bool is_exhaustive() const { return of != 0 && inputs >= of; }
};

/// As it is printed, and chosen by: "shininess, every u, highp".
std::string label(const std::string& name, const std::string& tier);

Result result_of(const Entry& entry, const Peak& peak);

/// Adds what another shard of the same run found. Throws input_error where the shards do not measure the same.
void merge(std::vector<Result>& into, const std::vector<Result>& other, const std::string& name_of_other);

/// 123 to 1,234,567.
std::string with_commas(uint64_t n);
/// Four significant digits, as a person writes them: 0, 0.5001, 816,600, 2.328e-10.
std::string figure(double x);

}  // namespace shade16::bounds
