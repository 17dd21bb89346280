#include "shade16/scene/materials.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <set>
#include <string>

namespace shade16 {
namespace {

TEST(Materials, TheTableHasTwentyFourRowsWithNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const NamedMaterial& row : classic_materials) names.insert(row.name);
    EXPECT_EQ(names.size(), 24u);
    EXPECT_EQ(std::size(classic_materials), 24u);
}

TEST(Materials, EveryRowIsFoundByItsName) {
    for (const NamedMaterial& row : classic_materials) EXPECT_EQ(find_material(row.name), &row.material) << row.name;
}

TEST(Materials, AnUnknownNameIsNoMaterial) {
    static_assert(find_material("unobtainium") == nullptr && find_material("") == nullptr);
    static_assert(find_material("emeral") == nullptr && find_material("emeralds") == nullptr && find_material("Emerald") == nullptr);
}

// 128 times the table's `shine` of 0.6, 0.21794872 and 0.088.
TEST(Materials, ExponentsAreThoseOfTheTable) {
    static_assert(find_material("emerald")->shininess == 76.8_q16);
    static_assert(find_material("brass")->shininess == 27.89743616_q16);
    static_assert(find_material("pearl")->shininess == 11.264_q16);
    static_assert(find_material("black_rubber")->shininess == 10_q16);
    for (const NamedMaterial& row : classic_materials) {
        EXPECT_GE(row.material.shininess, 10_q16) << row.name;
        EXPECT_LE(row.material.shininess, 76.8_q16) << row.name;
    }
}

TEST(Materials, ColoursAreThoseOfTheTable) {
    constexpr const Material* gold = find_material("gold");
    static_assert(gold->ambient_color() == Rgb{0.24725_unorm, 0.1995_unorm, 0.0745_unorm});
    static_assert(gold->diffuse == Rgb{0.75164_unorm, 0.60648_unorm, 0.22648_unorm});
    static_assert(gold->specular == Rgb{0.628281_unorm, 0.555802_unorm, 0.366065_unorm});
    static_assert(find_material("black_plastic")->ambient_color() == black, "given as black, so it is not the diffuse colour");
}

// Six rows of the table are translucent; nothing draws it, but a scene may read it.
TEST(Materials, AlphasAreThoseOfTheTable) {
    static_assert(find_material("emerald")->alpha == 0.55_unorm);
    static_assert(find_material("jade")->alpha == 0.95_unorm);
    static_assert(find_material("obsidian")->alpha == 0.82_unorm);
    static_assert(find_material("pearl")->alpha == 0.922_unorm);
    static_assert(find_material("ruby")->alpha == 0.55_unorm);
    static_assert(find_material("turquoise")->alpha == 0.8_unorm);
    int translucent = 0;
    for (const NamedMaterial& row : classic_materials) translucent += row.material.alpha != 1_unorm;
    EXPECT_EQ(translucent, 6);
}

TEST(Materials, TheAmbientColourIsTheDiffuseOneUnlessGiven) {
    static_assert(Material{.diffuse = rgb(0x102030)}.ambient_color() == rgb(0x102030));
    static_assert(Material{.ambient = rgb(0x405060), .diffuse = rgb(0x102030)}.ambient_color() == rgb(0x405060));
}

TEST(Materials, AreLitAndSmooth) {
    for (const NamedMaterial& row : classic_materials) {
        EXPECT_FALSE(row.material.unlit) << row.name;
        EXPECT_EQ(row.material.shading, Shading::gouraud) << row.name;
        EXPECT_EQ(row.material.emissive, black) << row.name;
    }
}

}  // namespace
}  // namespace shade16
