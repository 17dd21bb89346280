// A baked model as C++ text.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/model/quantize.hpp"

namespace shade16::host {

/// A header that includes <shade16/shade16.hpp> alone. In namespace `assets` it defines the arrays and
///   `name`           a shade16::Mesh, and `name_material`, its shade16::Material, for a model of one part;
///   `name_part`      and `name_part_material` for each part of a model with several.
/// Every number is the raw integer, so that the bits are those that were measured here.
std::string bake_header(const BakedModel& model, std::string_view name);

}  // namespace shade16::host
