// The classic materials as a table, as JSON and as a sheet of spheres.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "host_sim/gallery/canvas.hpp"
#include "host_sim/gallery/font.hpp"
#include "host_sim/io/png_reader.hpp"
#include "shade16/scene/materials.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_refused(const std::string& arguments, const std::string& sentence) {
    const ScratchDirectory scratch;
    const Ran ran = run_shell("cd '" + scratch.path("") + "' && \"$shade16\" materials " + arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_THAT(ran.err, HasSubstr(sentence));
    EXPECT_THAT(ran.out, IsEmpty());
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(CliMaterials, prints_a_table_of_all) {
    const Ran ran = shade16_program("materials");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 26);
    EXPECT_THAT(ran.out, HasSubstr("\nruby            0.1745 0.0117 0.0117   0.6142 0.0414 0.0414   "
                                   "0.7278 0.6270 0.6270      76.800  0.550\n"));
    for (const NamedMaterial& row : classic_materials)
        EXPECT_THAT(ran.out, HasSubstr(std::string("\n") + row.name + " "));
    EXPECT_THAT(ran.out, EndsWith("alpha is kept and not drawn.\n"));
    std::set<std::size_t> widths;  // aligned: all rows are as long as the first
    for (std::size_t at = 0, end; (end = ran.out.find('\n', at)) != std::string::npos; at = end + 1)
        widths.insert(end - at);
    EXPECT_EQ(widths.size(), 2u) << "the rows and the sentence below them";
}

TEST(CliMaterials, prints_json_for_scripts) {
    const json object = json::parse(shade16_program("materials --json").out);
    EXPECT_EQ(object["command"], "materials");
    EXPECT_EQ(object["alpha_is_drawn"], false);
    ASSERT_EQ(object["materials"].size(), 24u);
    EXPECT_EQ(object["materials"][0]["name"], "emerald");
    EXPECT_NEAR(object["materials"][0]["diffuse"][1].get<double>(), 0.61424, 1e-5);
    EXPECT_NEAR(object["materials"][0]["shininess"].get<double>(), 76.8, 1e-5);
    EXPECT_NEAR(object["materials"][0]["alpha"].get<double>(), 0.55, 1e-5);
    EXPECT_EQ(object["materials"][6]["alpha"], 1.0);
}

TEST(CliMaterials, draws_a_sheet_with_a_sphere_a_material_and_its_name) {
    const ScratchDirectory scratch;
    const Ran ran = shade16_program("materials -o " + scratch.path("a.png"));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, EndsWith("a.png: 24 materials, 632x460 pixels; alpha is kept and not drawn\n"));
    const Image sheet = read_png(scratch.path("a.png"));
    ASSERT_EQ(sheet.width, 632);
    ASSERT_EQ(sheet.height, 460);
    const auto at = [&](int x, int y) {
        const uint8_t* p = sheet.rgb.data() + 3 * (std::ptrdiff_t{y} * sheet.width + x);
        return Ink24{p[0], p[1], p[2]};
    };
    std::set<std::array<int, 3>> middles;
    for (int i = 0; i < 24; ++i) {
        const int left = 8 + i % 6 * 104, top = 8 + i / 6 * 113;
        const Ink24 middle = at(left + 48, top + 48);
        middles.insert({middle.r, middle.g, middle.b});
        EXPECT_EQ(at(left, top), paper) << "a sphere leaves the corners of its picture";
        // The name below it, letter by letter.
        const std::string name = classic_materials[i].name;
        const int begin = left + (96 - text_width_px(name)) / 2;
        for (int x = 0; x < text_width_px(name); ++x)
            for (int y = 0; y < glyph_rows_px; ++y) {
                const int column = x % glyph_pitch_px;
                const char letter = name[static_cast<std::size_t>(x / glyph_pitch_px)];
                const bool is_ink =
                    column < glyph_width_px && (glyph_of(letter)[static_cast<std::size_t>(column)] >> y & 1);
                ASSERT_EQ(at(begin + x, top + 99 + y) == letters, is_ink) << name << " " << x << " " << y;
            }
    }
    EXPECT_EQ(middles.size(), 24u) << "no two materials look alike";
}

TEST(CliMaterials, draws_as_it_is_told) {
    const ScratchDirectory scratch;
    const auto drawn = [&](const std::string& options) {
        const Ran ran = shade16_program("materials -o " + scratch.path("a.png") + " --quiet --size 40x30 " + options);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_THAT(ran.out + ran.err, IsEmpty());
        return read_png(scratch.path("a.png")).rgb;
    };
    const auto usual = drawn("");
    EXPECT_EQ(drawn("--shading gouraud --tier mediump"), usual) << "the table's own, and the usual tier";
    EXPECT_NE(drawn("--shading flat"), usual);
    EXPECT_NE(drawn("--shading phong"), usual);
    EXPECT_NE(drawn("--tier lowp"), usual);
    const json object = json::parse(shade16_program("materials --json --size 40x30 -o " + scratch.path("a.png")).out);
    EXPECT_EQ(object["width"], read_png(scratch.path("a.png")).width);
}

TEST(CliMaterials, what_is_wrong_is_refused) {
    expect_refused("-o sheet.jpg", "--output sheet.jpg: is no name of a picture; expected one that ends in .png.");
    expect_refused("-o -", "--output -: is no name of a picture");
    expect_refused("-o a.png --size 2000x10", "--size 2000x10: makes a sheet of 12056 pixels; expected at most 8192.");
    expect_refused("-o a.png --size 0x10", "--size 0x10: expected WIDTHxHEIGHT");
    expect_refused("-o a.png --tier midiump", "did you mean mediump?");
    expect_refused("--shading phong",
                   "--shading: the table has none; expected -o and the name of a picture beside it.");
    expect_refused("--size 20x20", "--size: the table has none");
    expect_refused("brass", "brass: is one word too many; expected options alone; see 'shade16 materials --help'.");
}

TEST(CliMaterials, a_sheet_that_can_not_be_written_is_the_machines_fault) {
    const Ran ran = shade16_program("materials -o /no/such/directory/a.png");
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_THAT(ran.err, HasSubstr("/no/such/directory/a.png"));
}

TEST(CliMaterials, info_says_that_alpha_is_not_drawn) {
    const std::string scene = (source_directory() / "assets/scenes/everything.toml").string();
    EXPECT_THAT(shade16_program("info " + scene).out,
                HasSubstr("  4 objects have alpha below 1: alpha is kept and not drawn\n"));
    EXPECT_EQ(json::parse(shade16_program("info --json " + scene).out)["objects_with_alpha_below_1"], 4);
    EXPECT_THAT(shade16_program("info " + teapot()).out, testing::Not(HasSubstr("alpha")));
}

TEST(Font, tells_every_printable_character_from_every_other) {
    std::set<std::array<uint8_t, glyph_width_px>> glyphs;
    for (char c = ' '; c <= '~'; ++c) glyphs.insert(glyph_of(c));
    EXPECT_EQ(glyphs.size(), 95u);
    EXPECT_EQ(glyph_of('\n'), glyph_of('?'));
    EXPECT_EQ(glyph_of('\xE9'), glyph_of('?'));
}

}  // namespace
}  // namespace shade16::host
