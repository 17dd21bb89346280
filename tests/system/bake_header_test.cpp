#include "host_sim/model/bake_header.hpp"

#include <gmock/gmock.h>

#include "host_sim/model/identifier.hpp"
#include "host_sim/model/obj_import.hpp"
#include "tests/requirements.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using testing::HasSubstr;
using testing::Not;

BakedModel baked(const ScratchDirectory& scratch, const std::string& obj) {
    return quantize(import_obj(scratch.write("a.obj", obj)));
}

const std::string two_parts =
    "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nusemtl dark wood\nf 1 2 3\nusemtl dark-wood\nf 1 3 2\n";
const std::string two_materials =
    "newmtl dark wood\nKd 1 0 0\nillum 0\nnewmtl dark-wood\nKa 0 0 0\nKs 1 1 1\nNs 76.8\n";

/// Compiles the header as firmware would; the file also checks `assertions` at compile time.
void expect_compiles(const ScratchDirectory& scratch, const std::string& compiler, const std::string& header,
                     const std::string& assertions) {
    scratch.write("mesh.hpp", header);
    const std::string source = scratch.write("use.cpp", "#include \"mesh.hpp\"\n#include \"mesh.hpp\"\n" + assertions);
    const std::string command = compiler +
                                " -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -fsyntax-only -I " +
                                (source_directory() / "core/include").string() + " " + source + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << compiler;
}

class BakeHeaderCompiles : public testing::TestWithParam<const char*> {};

TEST_P(BakeHeaderCompiles, with_the_bits_that_were_measured) {
    if (!has_program(GetParam())) GTEST_SKIP() << GetParam() << " is not installed.";
    const ScratchDirectory scratch;
    const BakedModel teapot = quantize(import_obj((source_directory() / "assets/teapot.obj").string()));
    const BakedPart& part = teapot.parts[0];
    std::string assertions = fmt::format(
        "static_assert(assets::teapot.positions.count == {});\nstatic_assert(assets::teapot.triangles.count == {});\n"
        "static_assert(assets::teapot.centre.y.raw == {});\nstatic_assert(assets::teapot_material.shininess.raw == "
        "{});\n",
        part.positions.size(), part.triangles.size(), teapot.centre.y.raw, part.material.shininess.raw);
    for (std::size_t i : {std::size_t{0}, std::size_t{100}, part.positions.size() - 1})
        assertions += fmt::format(
            "static_assert(assets::teapot.positions[{0}].x == {1} && assets::teapot.normals[{0}].z.raw == {2});\n", i,
            part.positions[i].x, part.normals[i].z.raw);
    expect_compiles(scratch, GetParam(), bake_header(teapot, "teapot"), assertions);

    scratch.write("a.mtl", two_materials);
    expect_compiles(scratch, GetParam(), bake_header(baked(scratch, two_parts), "2 chairs"),
                    "static_assert(assets::mesh_2_chairs_dark_wood.colors[0].r.raw == 65535 && "
                    "assets::mesh_2_chairs_dark_wood_material.unlit);\n"
                    "static_assert(assets::mesh_2_chairs_dark_wood_2_material.ambient.given);\n"
                    "static_assert(assets::mesh_2_chairs_dark_wood_2_material.specular == shade16::white);\n");
}

INSTANTIATE_TEST_SUITE_P(, BakeHeaderCompiles, testing::Values("g++", "clang++", "arm-none-eabi-g++"));

TEST(BakeHeader, says_what_it_is_and_how_it_was_made_without_a_path) {
    const ScratchDirectory scratch;
    const std::string text = bake_header(baked(scratch, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "tri");
    EXPECT_THAT(text, testing::StartsWith(
                          "// Made by: shade16 bake a.obj -o tri.hpp\n// 3 vertices, 1 triangles, 42 bytes of flash."));
    EXPECT_THAT(text, HasSubstr("inline constexpr shade16::Position16 tri_positions[] = {\n    {0, 0, 0}, {16384, 0, "
                                "0}, {0, 16384, 0},\n};\n"));
    EXPECT_THAT(text, HasSubstr("inline constexpr shade16::Mesh tri{\n"));
    EXPECT_THAT(text, Not(HasSubstr(scratch.path(""))));
}

TEST(BakeHeader, no_line_is_too_long_and_no_file_name_leaves_its_comment) {
    BakedModel model = quantize(import_obj((source_directory() / "assets/teapot.obj").string()));
    model.source = "evil\\\nname\\";
    const std::string text = bake_header(model, "teapot");
    EXPECT_THAT(text, testing::StartsWith("// Made by: shade16 bake evil__name_ -o"));
    for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
        end = text.find('\n', at);
        ASSERT_LE(end - at, 120u);
    }
}

TEST(BakeHeader, is_the_same_each_time) {
    const ScratchDirectory scratch;
    scratch.write("a.mtl", two_materials);
    EXPECT_EQ(bake_header(baked(scratch, two_parts), "x"), bake_header(baked(scratch, two_parts), "x"));
}

TEST(Identifier, is_a_valid_name_for_any_text) {
    EXPECT_EQ(identifier("teapot"), "teapot");
    EXPECT_EQ(identifier("dark wood.001"), "dark_wood_001");
    EXPECT_EQ(identifier("__Reserved__"), "Reserved");
    EXPECT_EQ(identifier("9lives"), "mesh_9lives");
    EXPECT_EQ(identifier("new"), "new_");
    EXPECT_EQ(identifier("shade16"), "shade16_");
    EXPECT_EQ(identifier("\xC3\xA4"), "mesh");
    EXPECT_EQ(identifier(""), "mesh");
}

TEST(Identifier, is_never_used_for_two_things) {
    const std::array<std::string, 2> suffixes{"", "_positions"};
    UniqueNames names;
    EXPECT_EQ(names.claim("wall", suffixes), "wall");
    EXPECT_EQ(names.claim("wall", suffixes), "wall_2");
    EXPECT_EQ(names.claim("wall_positions", suffixes), "wall_positions_2");
}

}  // namespace
}  // namespace shade16::host
