// Measures what some files of host_sim/bounds add: a program that compiles in seconds, for mutants.py.
#include <cstdio>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/measure.hpp"

int main() {
    using namespace shade16::bounds;
    Entries all;
    SHADE16_ADD
    int broken = 0;
    for (const Entry& entry : all.all()) {
        const Peak peak = measure(entry, ordinary_spans(entry));
        if (peak.error <= entry.bound) continue;
        std::printf("%s%s%s is off %.6g %s, expected at most %.6g\n", entry.name.c_str(),
                    entry.tier.empty() ? "" : ", ", entry.tier.c_str(), peak.error, entry.unit.c_str(), entry.bound);
        ++broken;
    }
    return broken == 0 ? 0 : 1;
}
