#include "host_sim/cli/bounds_json.hpp"

#include <fstream>

#include <nlohmann/json.hpp>

#include "host_sim/error.hpp"

namespace shade16::host {

std::string bounds_json(const std::vector<bounds::Result>& results) {
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    for (const bounds::Result& r : results)
        entries.push_back({{"name", r.name},
                           {"tier", r.tier},
                           {"unit", r.unit},
                           {"bound", r.bound},
                           {"measured", r.measured},
                           {"inputs", r.inputs},
                           {"of", r.of},
                           {"worst_input", r.at},
                           {"kept", r.holds()},
                           {"header", r.header},
                           {"functions", r.functions}});
    return nlohmann::ordered_json{{"schema", 1}, {"command", "report bounds"}, {"bounds", entries}}.dump(1) + "\n";
}

std::vector<bounds::Result> read_bounds_json(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw io_error("{}: cannot be opened; expected a bounds.json that 'shade16 report bounds' wrote.", path);
    std::vector<bounds::Result> results;
    try {
        const nlohmann::json whole = nlohmann::json::parse(file);
        for (const auto& e : whole.at("bounds"))
            results.push_back({.name = e.at("name"),
                               .header = e.at("header"),
                               .functions = e.at("functions"),
                               .unit = e.at("unit"),
                               .tier = e.at("tier"),
                               .bound = e.at("bound"),
                               .measured = e.at("measured"),
                               .at = e.at("worst_input"),
                               .inputs = e.at("inputs"),
                               .of = e.at("of")});
    } catch (const nlohmann::json::exception&) {
        throw input_error("{}: is no bounds.json; expected one that 'shade16 report bounds' wrote.", path);
    }
    return results;
}

}  // namespace shade16::host
