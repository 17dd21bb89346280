// Panels as text: the files of boards/panels, or a user's own, read at run time. docs/panels.md has the format.
#pragma once

#include <stdint.h>

#include <display/dcs.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace shade16::host {

/// A panel with all that it points to.
struct PanelFile {
    std::string name{};                // the file's, without folder and ending
    std::vector<uint8_t> beginning{};  // a list of command_list.hpp
    DcsPanel facts{};                  // but for the name and the beginning

    /// For the drivers of firmware/display. It points into this, and ends with it.
    DcsPanel panel() const;
};

using ReadText = std::function<std::string(const std::string& path)>;

/// Throws input_error, with file and line, for what is no panel; what read_text of host_sim/model throws for what is no text.
PanelFile read_panel_file(const std::string& path);

/// The same for a text already read. `path` gives the panel its name, and `read` the file that it stands on, from the same folder.
PanelFile read_panel_text(std::string_view text, const std::string& path, const ReadText& read);

}  // namespace shade16::host
