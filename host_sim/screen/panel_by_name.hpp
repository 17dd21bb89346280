// A panel by what a person calls it.
#pragma once

#include <display/dcs.hpp>
#include <memory>
#include <string>

namespace shade16::host {

/// With all that it points to.
using Panel = std::shared_ptr<const DcsPanel>;

/// `name` is one that panels_text has, or a file that ends with .txt. Throws input_error.
Panel panel_by_name(const std::string& name);

/// The panels that have a name and their sizes, a line each.
std::string panels_text();

}  // namespace shade16::host
