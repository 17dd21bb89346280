#include "host_sim/bounds/result.hpp"

#include <cmath>

#include <fmt/format.h>

#include "host_sim/error.hpp"

namespace shade16::bounds {

std::string label(const std::string& name, const std::string& tier) { return tier.empty() ? name : name + ", " + tier; }

Result result_of(const Entry& entry, const Peak& peak) {
    const bool is_counted = entry.domain == Domain::every_argument;
    return {.name = entry.name,
            .header = entry.header,
            .functions = entry.functions,
            .unit = entry.unit,
            .tier = entry.tier,
            .bound = entry.bound,
            .measured = peak.inputs == 0 ? 0 : peak.error,
            .at = peak.at,
            .inputs = peak.inputs,
            .of = is_counted ? entry.inputs.last - entry.inputs.first + 1 : 0};
}

void merge(std::vector<Result>& into, const std::vector<Result>& other, const std::string& name_of_other) {
    if (into.size() != other.size())
        throw host::input_error("{}: holds {} entries; expected {}, as in the first.", name_of_other, other.size(),
                                into.size());
    for (std::size_t i = 0; i < into.size(); ++i) {
        Result& a = into[i];
        const Result& b = other[i];
        if (a.name != b.name || a.tier != b.tier || a.bound != b.bound)
            throw host::input_error("{}: entry {} is {} {}; expected {} {} with the same bound, as in the first.",
                                    name_of_other, i, b.name, b.tier, a.name, a.tier);
        if (!(b.measured <= a.measured)) a.measured = b.measured, a.at = b.at;
        a.inputs += b.inputs;
    }
}

std::string with_commas(uint64_t n) {
    return n < 1000 ? fmt::format("{}", n) : fmt::format("{},{:03}", with_commas(n / 1000), n % 1000);
}

std::string figure(double x) {
    if (x >= 10'000 && x < 1e12) return with_commas(static_cast<uint64_t>(std::llround(x)));
    return fmt::format("{:.4g}", x);
}

}  // namespace shade16::bounds
