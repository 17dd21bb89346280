#include "host_sim/model/obj_import.hpp"

#include <gmock/gmock.h>

#include "tests/system/imported.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MtlImport, materials_become_parts_in_the_order_of_use) {
    const Model model = imported(
        "mtllib a.mtl\n" + triangle + "usemtl second one\nf 1 2 3\nusemtl first\nf 1 3 2\nusemtl second one\nf 1 2 3\n",
        "newmtl first\nKd 1 0 0\nnewmtl  second   one \nKd 0 0 1\n");
    ASSERT_EQ(model.parts.size(), 2u);
    EXPECT_EQ(model.parts[0].name, "second one");
    EXPECT_EQ(model.parts[0].material.diffuse, rgb(0x0000FF));
    EXPECT_EQ(model.parts[0].triangles.size(), 2u);
    EXPECT_EQ(model.parts[1].material.diffuse, rgb(0xFF0000));
}

ModelPart part_with(const std::string& mtl, std::vector<std::string>* warnings = nullptr) {
    const Model model = imported("mtllib a.mtl\nusemtl m\n" + triangle + "f 1 2 3\n", "newmtl m\n" + mtl);
    if (warnings) *warnings = model.warnings;
    return model.parts.at(0);
}

TEST(MtlImport, illum_decides_which_terms_there_are) {
    const std::string colors = "Ka 0.2 0.2 0.2\nKd 0 1 0\nKs 1 1 1\nKe 0 0 1\nNs 250\n";
    EXPECT_TRUE(part_with(colors + "illum 0\n").material.unlit);
    EXPECT_EQ(part_with(colors + "illum 1\n").material.specular, black);
    for (const char* all : {"", "illum 2\n", "illum 3\n"}) {
        const Material material = part_with(colors + all).material;
        EXPECT_FALSE(material.unlit);
        EXPECT_EQ(material.specular, white);
        EXPECT_EQ(material.emissive, rgb(0x0000FF));
        EXPECT_EQ(material.ambient_color(), rgb(0x333333));
        EXPECT_EQ(material.shininess, Q16(250));
    }
}

TEST(MtlImport, ambient_follows_diffuse_when_absent_or_one_but_not_when_black) {
    EXPECT_EQ(part_with("Kd 0 1 0\n").material.ambient_color(), rgb(0x00FF00));
    EXPECT_EQ(part_with("Kd 0 1 0\nKa 1 1 1\n").material.ambient_color(), rgb(0x00FF00));
    EXPECT_EQ(part_with("Kd 0 1 0\nKa 0 0 0\n").material.ambient_color(), black);
}

TEST(MtlImport, what_cannot_be_drawn_is_said_once) {
    std::vector<std::string> warnings;
    const ModelPart part = part_with("Kd 2 0 0\nKs 1 1 1\nNs 5000\nd 0.5\nillum 4\nmap_Ks wall.png\n", &warnings);
    EXPECT_EQ(part.material.shininess, Q16(1000));
    EXPECT_EQ(part.material.diffuse, rgb(0xFF0000));
    EXPECT_THAT(part.notes, ElementsAre("map_Ks wall.png", "Transparency (d) 0.5", "illum 4"));
    EXPECT_THAT(warnings,
                ElementsAre("A colour outside of 0 to 1 was clamped (material m).",
                            "Ns 5000 is drawn as Ns 1000, as exponents go from 1 to 1000 (material m).",
                            "map_Ks is not drawn (material m).", "Transparency (d) is not drawn (material m).",
                            "illum 4 is drawn as illum 2 (material m)."));
    part_with("Ns 0\nKs 0 0 0\n", &warnings);
    EXPECT_THAT(warnings, IsEmpty()) << "an exponent without a specular colour does not matter";
}

TEST(MtlImport, a_missing_library_is_a_warning_and_grey) {
    const Model model = imported("mtllib gone.mtl\nusemtl m\n" + triangle + "f 1 2 3\n");
    EXPECT_THAT(
        model.warnings,
        ElementsAre("The material library 'gone.mtl' cannot be read; what it describes is drawn in neutral grey."));
    EXPECT_EQ(model.parts[0].material.diffuse, rgb(0xCCCCCC));
    EXPECT_EQ(model.parts[0].material.specular, rgb(0x666666));
    EXPECT_EQ(model.parts[0].material.shininess, Q16(32));
    const Model other = imported("mtllib a.mtl\nusemtl m\n" + triangle + "f 1 2 3\n", "newmtl n\n");
    EXPECT_THAT(other.warnings,
                ElementsAre("The material 'm' is in no material library; it is drawn in neutral grey."));
}

TEST(MtlImport, a_material_without_a_name_is_still_a_material) {
    const Model model = imported("mtllib a.mtl\n" + triangle + "usemtl \nf 1 2 3\n", "newmtl \nKd 1 0 0\n");
    EXPECT_EQ(model.parts[0].name, "unnamed");
    EXPECT_EQ(model.parts[0].material.diffuse, rgb(0xFF0000));
}

}  // namespace
}  // namespace shade16::host
