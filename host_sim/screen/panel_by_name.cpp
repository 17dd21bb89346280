#include "host_sim/screen/panel_by_name.hpp"

#include <display/all_panels.hpp>
#include <cctype>
#include <vector>

#include "host_sim/error.hpp"
#include "host_sim/nearest_word.hpp"
#include "host_sim/screen/panel_file.hpp"

namespace shade16::host {

namespace {

Panel panel_of_file(const std::string& path) {
    struct Kept {
        explicit Kept(const std::string& path) : file(read_panel_file(path)) {}
        PanelFile file;
        DcsPanel view = file.panel();  // points into the file, so they stay together
    };
    const auto kept = std::make_shared<const Kept>(path);
    return {kept, &kept->view};
}

/// Modules have their controllers' names on them in capitals.
std::string lower_case(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

Error unknown_panel(const std::string& name) {
    std::vector<std::string> known;
    for (const DcsPanel& panel : all_panels) known.emplace_back(panel.name);
    const std::string near = nearest_word(lower_case(name), known);
    return input_error("panel '{}': there is none of this name; {}.", name,
                       near.empty() ? "expected one of --list-panels, or a file that ends with .txt" : "expected '" + near + "', or another one of --list-panels");
}

}  // namespace

Panel panel_by_name(const std::string& name) {
    if (name.ends_with(".txt")) return panel_of_file(name);
    for (const DcsPanel& panel : all_panels)
        if (lower_case(name) == panel.name) return std::make_shared<const DcsPanel>(panel);
    throw unknown_panel(name);
}

std::string panels_text() {
    std::string text;
    for (const DcsPanel& panel : all_panels) text += fmt::format("{:<24}{}x{}\n", panel.name, panel.width_px, panel.height_px);
    return text;
}

}  // namespace shade16::host
