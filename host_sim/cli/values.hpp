// The values of options, from the words that the user typed. Each throws input_error with the option, the word and what
// was expected instead.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/cli/options.hpp"

namespace shade16::host {

int whole_number(std::string_view option, const std::string& word, int least, int largest);

/// "320x240"
Viewport size_of(const std::string& word);

Shading shading_of(const std::string& word);
NormalPath normals_of(const std::string& word);
Reflection reflection_of(const std::string& word);
LightTable light_table_of(const std::string& word);
Filter filter_of(const std::string& word);
Mapping mapping_of(const std::string& word);
Component component_of(const std::string& word);
double crease_of(const std::string& word);  // degrees
Engine engine_of(const std::string& word);
ScreenKind screen_kind_of(const std::string& word);
int quarter_turns_of(const std::string& word);
uint8_t spi_mode_of(const std::string& word);
uint32_t hz_of(const std::string& word);  // "32M", "31.25MHz", "500k" or a number
std::string tier_of(const std::string& word);
std::string format_of(const std::string& word);
std::string dither_of(const std::string& word);
std::string subject_of(const std::string& word);  // of a report
bounds::Shard shard_of(const std::string& word);

/// The name of a PNG file, as it is.
std::string picture_of(const std::string& path);

/// From the ending of the path; `-` is Y4M.
OutputKind kind_of(const std::string& path);

}  // namespace shade16::host
