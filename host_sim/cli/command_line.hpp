// The command line, understood or refused.
#pragma once

#include <string>
#include <variant>

#include "host_sim/cli/options.hpp"

namespace shade16::host {

/// Something to be printed instead of any work: help, or the version.
struct Answer {
    std::string text{};
};

using Command = std::variant<Answer, RenderOptions, CompareOptions, BakeOptions, InfoOptions, PreviewOptions, ShowOptions, MaterialsOptions,
                             GalleryOptions, ReportOptions>;

/// Throws input_error with one sentence.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace shade16::host
