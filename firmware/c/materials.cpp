// The classic materials as C structs, in flash. A file of its own, so that a program that asks for none has no table.
#include "convert.hpp"
#include "shade16/scene/materials.hpp"

namespace {
constexpr size_t count = sizeof(shade16::classic_materials) / sizeof(shade16::classic_materials[0]);

struct Table {
    shade16_material row[count]{};

    consteval Table() {
        for (size_t i = 0; i < count; ++i) row[i] = shade16::c::as_c(shade16::classic_materials[i].material);
    }
};
constexpr Table table;
}  // namespace

extern "C" const shade16_material* shade16_find_material(const char* name) {
    if (name == nullptr) return nullptr;
    for (size_t i = 0; i < count; ++i) {
        const char *a = shade16::classic_materials[i].name, *b = name;
        while (*a != 0 && *a == *b) ++a, ++b;
        if (*a == *b) return &table.row[i];
    }
    return nullptr;
}
