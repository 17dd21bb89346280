// Lights.
#include "host_sim/scene_file/decimal.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range intensities{0, 1'000'000}, factors{0, 16384}, powers{0, 2}, ranges{0, 16384};
constexpr Range cone_angles{0, 90}, cone_exponents{0, 128};

const std::vector<std::string> kinds{"ambient", "directional", "point", "spot"};

LightKind kind_of_light(const SceneTables& tables, const std::string& what, const TomlValue& value) {
    const std::vector<std::string> any{"kind",     "color",       "diffuse", "specular", "intensity", "space",   "direction",
                                       "position", "attenuation", "range",   "inner",    "outer",     "exponent"};
    const auto kind = tables.reader(what, value, any).word("kind", kinds);
    return kind ? static_cast<LightKind>(*kind) : Light{}.kind;
}

std::vector<std::string> keys_of(LightKind kind) {
    switch (kind) {
        case LightKind::ambient:
            return {"kind", "color", "intensity"};
        case LightKind::directional:
            return {"kind", "color", "diffuse", "specular", "intensity", "space", "direction"};
        case LightKind::spot:
            return {"kind",      "color",    "diffuse",     "specular", "intensity", "space",
                    "direction", "position", "attenuation", "range",    "inner",     "outer", "exponent"};
        default:
            return {"kind", "color", "diffuse", "specular", "intensity", "space", "position", "attenuation", "range"};
    }
}

Attenuation read_attenuation(const SceneTables& tables, const std::string& what, const TomlValue& value) {
    const TableReader table =
        tables.reader("the attenuation of " + what, value, {"constant", "linear", "quadratic", "power"});
    Attenuation a;
    table.read("constant", a.constant, factors);
    table.read("linear", a.linear, factors);
    table.read("quadratic", a.quadratic, factors);
    table.read("power", a.power, powers);
    if (a.constant == Q16{} && a.linear == Q16{} && a.quadratic == Q16{})
        throw table.wrong("constant", "is 0 as all three are; expected one above 0");
    return a;
}

Spot read_spot(const TableReader& table) {
    const auto angle = [&](const char* key, Angle& value) {
        double degrees = 0;
        if (!table.has(key)) return;
        table.read(key, degrees, cone_angles);
        value = degrees_of(degrees);
    };
    Spot spot;
    table.read("direction", spot.direction, coordinates);
    if (spot.direction == Vec3{})
        throw table.wrong("direction", "has no length; expected where the spot shines to, such as [0, -1, 0]");
    angle("inner", spot.inner);
    angle("outer", spot.outer);
    if (spot.outer.turns < spot.inner.turns)
        throw table.wrong("inner", fmt::format("is {}; expected at most outer, which is {}",
                                               decimal_degrees(spot.inner), decimal_degrees(spot.outer)));
    table.read("exponent", spot.exponent, cone_exponents);
    return spot;
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
    const char* const place = light.is_lamp() ? "position" : "direction";
    table.read(place, light.position, coordinates);
    table.read("range", light.range, ranges);
    if (kind == LightKind::spot) light.spot = read_spot(table);
    if (kind == LightKind::directional && light.position == Vec3{})
        throw table.wrong(place, "has no length; expected the direction towards the light, such as [1, 2, 3]");
    if (const TomlValue* const found = table.find("attenuation"))
        light.attenuation = read_attenuation(tables, name, *found);
    return light;
}

}  // namespace shade16::host
