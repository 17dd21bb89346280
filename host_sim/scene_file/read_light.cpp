// Lights.
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range intensities{0, 1'000'000}, factors{0, 16384};

const std::vector<std::string> kinds{"ambient", "directional", "point"};

LightKind kind_of_light(const SceneTables& tables, const std::string& what, const TomlValue& value) {
    const std::vector<std::string> any{"kind",  "color",     "diffuse",  "specular",   "intensity",
                                       "space", "direction", "position", "attenuation"};
    const auto kind = tables.reader(what, value, any).word("kind", kinds);
    return kind ? static_cast<LightKind>(*kind) : Light{}.kind;
}

std::vector<std::string> keys_of(LightKind kind) {
    switch (kind) {
        case LightKind::ambient:
            return {"kind", "color", "intensity"};
        case LightKind::directional:
            return {"kind", "color", "diffuse", "specular", "intensity", "space", "direction"};
        default:
            return {"kind", "color", "diffuse", "specular", "intensity", "space", "position", "attenuation"};
    }
}

Attenuation read_attenuation(const SceneTables& tables, const std::string& what, const TomlValue& value) {
    const TableReader table = tables.reader("the attenuation of " + what, value, {"constant", "linear", "quadratic"});
    Attenuation a;
    table.read("constant", a.constant, factors);
    table.read("linear", a.linear, factors);
    table.read("quadratic", a.quadratic, factors);
    if (a == Attenuation{0, 0, 0}) throw table.wrong("constant", "is 0 as all three are; expected one above 0");
    return a;
}

}  // namespace

Light read_light(const SceneTables& tables, const TomlValue& value, std::size_t number) {
    const std::string name = fmt::format("light {}", number);
    const LightKind kind = kind_of_light(tables, name, value);
    const std::string what = fmt::format("{} ({})", name, kinds[static_cast<std::size_t>(kind)]);
    const TableReader table = tables.reader(what, value, keys_of(kind));
    Light light = kind == LightKind::ambient ? ambient_light(white) : Light{.kind = kind};
    table.read("color", light.diffuse);
    if (kind != LightKind::ambient) light.specular = light.diffuse;
    table.read("diffuse", light.diffuse);
    table.read("specular", light.specular);
    table.read("intensity", light.intensity, intensities);
    if (const auto i = table.word("space", {"world", "view", "object"})) light.space = static_cast<Space>(*i);
    const char* const place = kind == LightKind::point ? "position" : "direction";
    table.read(place, light.position, coordinates);
    if (kind == LightKind::directional && light.position == Vec3{})
        throw table.wrong(place, "has no length; expected the direction towards the light, such as [1, 2, 3]");
    if (const TomlValue* const found = table.find("attenuation"))
        light.attenuation = read_attenuation(tables, name, *found);
    return light;
}

}  // namespace shade16::host
