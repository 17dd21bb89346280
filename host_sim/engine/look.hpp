// Look: what the command line says of every material, whatever the files say.
#pragma once

#include <optional>

#include "shade16/scene/material.hpp"

namespace shade16::host {

struct Look {
    std::optional<Shading> shading{};
    std::optional<NormalPath> normals{};
    std::optional<Reflection> reflection{};
    std::optional<LightTable> light_table{};
    std::optional<Filter> filter{};
    std::optional<Mapping> mapping{};

    bool says_nothing() const { return !shading && !normals && !reflection && !light_table && !filter && !mapping; }
    void apply_to(Material& m) const {
        m.shading = shading.value_or(m.shading);
        m.normal_path = normals.value_or(m.normal_path);
        m.reflection = reflection.value_or(m.reflection);
        m.light_table = light_table.value_or(m.light_table);
        m.filter = filter.value_or(m.filter);
        m.mapping = mapping.value_or(m.mapping);
    }
};

}  // namespace shade16::host
