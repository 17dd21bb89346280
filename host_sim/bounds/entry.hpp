// What the engine promises of one function, and how its error is measured: the inputs are numbered, so that they can be
// taken all, every so many, or a share of them on each of several machines.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/bounds/dice.hpp"
#include "shade16/num/ulps.hpp"

namespace shade16::bounds {

/// A constant of a header in its unit.
inline double in_ulps(Ulps error) { return error.milli / 1000.0; }

/// The larger error; a NaN is larger than any.
inline double larger(double a, double b) { return a >= b || std::isnan(a) ? a : b; }
inline long double larger(long double a, long double b) { return a >= b || std::isnan(a) ? a : b; }

/// Every stride-th input from first to last.
struct Span {
    uint64_t first = 0, last = 0, stride = 1;
};

/// The largest error that was found, and where.
struct Peak {
    double error = -1;
    uint64_t at = 0, inputs = 0;

    void add(double e, uint64_t input) {
        ++inputs;
        if (std::isnan(e)) e = std::numeric_limits<double>::max();
        if (e > error) error = e, at = input;
    }
    void add(const Peak& other) {
        inputs += other.inputs;
        if (other.error > error) error = other.error, at = other.at;
    }
};

/// What the numbers of a domain stand for.
enum class Domain { every_argument, random_cases };

struct Entry {
    std::string name;
    std::string header;     // below core/include/shade16/
    std::string functions;  // what it measures, as the header names them, with spaces between
    std::string unit;       // of bound and error
    std::string tier{};     // empty where the error is that of every tier
    double bound = 0;
    Domain domain = Domain::every_argument;
    Span inputs{0, UINT32_MAX};  // in full
    /// The error for each input of a span.
    std::function<Peak(const Span&)> measure{};
};

class Entries {
public:
    /// `error` is called with each argument.
    template <class Error>
    void add(Entry entry, Error error) {
        entry.measure = [error](const Span& span) {
            Peak peak;
            for (uint64_t i = span.first;; i += span.stride) {
                peak.add(error(i), i);
                if (span.last - i < span.stride) return peak;
            }
        };
        all_.push_back(std::move(entry));
    }
    /// An entry that measures spans itself.
    void add(Entry entry) { all_.push_back(std::move(entry)); }
    /// `error` is called with the Dice of each random case.
    template <class Error>
    void add_random(Entry entry, Error error, uint64_t cases = 100'000'000) {
        entry.domain = Domain::random_cases;
        entry.inputs = {0, cases - 1};
        add(std::move(entry), [error](uint64_t number) {
            Dice dice(number);
            return error(dice);
        });
    }

    const std::vector<Entry>& all() const { return all_; }

private:
    std::vector<Entry> all_;
};

}  // namespace shade16::bounds
