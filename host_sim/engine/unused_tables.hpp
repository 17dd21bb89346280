// Light tables that a scene asks for, and whether the engine looks anything up in them.
#pragma once

#include <string>
#include <vector>

#include "shade16/scene/scene.hpp"

namespace shade16::host {

/// Why the pixels of an object that asks for a light table are lit one by one all the same, for an end of a sentence;
/// nullptr where they come from the table. As the engine decides it.
const char* obstacle_to_light_table(const Object& object, View<Light> lights, const Camera& camera);

/// A sentence for each obstacle, with the objects that it stands in the way of.
std::vector<std::string> warnings_of_unused_tables(const Scene& scene);

}  // namespace shade16::host
