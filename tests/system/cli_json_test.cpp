// Figures for scripts: one JSON object on standard output, with a schema, whatever the command.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "host_sim/report/memory.hpp"
#include "host_sim/report/terms.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

json printed(const std::string& arguments) {
    const Ran ran = shade16_program(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const json object = json::parse(ran.out, nullptr, false);
    EXPECT_TRUE(object.is_object()) << ran.out;
    EXPECT_EQ(object.value("schema", 0), 1);
    EXPECT_TRUE(object["warnings"].is_array());
    return object;
}

TEST(CliJson, compare_prints_what_its_table_says) {
    const json object = printed("compare " + teapot() + " --frames 1 --json");
    EXPECT_EQ(object["command"], "compare");
    EXPECT_EQ(object["verdict"], "kept");
    ASSERT_EQ(object["tiers"].size(), 3u);
    EXPECT_EQ(object["tiers"][1]["tier"], "mediump");
    EXPECT_EQ(object["tiers"][1]["promise_levels"]["to_exponent_128"], 0.75);
    for (const json& tier : object["tiers"]) {
        EXPECT_TRUE(tier["kept"]);
        EXPECT_GT(tier["vertices"]["largest_levels"], 0);
        EXPECT_LT(tier["vertices"]["largest_share_of_bound"], 1);
    }
}

TEST(CliJson, bake_and_render_print_their_figures_beside_the_data) {
    const ScratchDirectory scratch;
    EXPECT_EQ(printed("bake " + teapot() + " --json -o " + scratch.path("a.hpp"))["flash_bytes"], 12300);
    const json drawn = printed("render " + teapot() + " --json --size 60x40 --scale 2 -o " + scratch.path("a.png"));
    EXPECT_EQ(drawn["width"], 120);
    EXPECT_EQ(drawn["frames"], 1);
    EXPECT_GT(drawn["fit"]["brightest_code"], 200);

    const std::string scene = (source_directory() / "assets/scenes/everything.toml").string();
    const json baked = printed("bake " + scene + " --json -o " + scratch.path("s.hpp"));
    EXPECT_EQ(baked["vertices"], 532);
    EXPECT_EQ(baked["flash_bytes"], 12216);
    EXPECT_EQ(baked["objects"], 11);
    EXPECT_EQ(baked["lights"], 5);
    EXPECT_EQ(baked["frames"], 120);

    const Ran piped = shade16_program("bake " + teapot() + " --json -o -");
    EXPECT_TRUE(json::accept(piped.err)) << piped.err;
    EXPECT_THAT(piped.out, HasSubstr("shade16::Mesh"));
}

TEST(CliJson, a_name_that_is_not_utf8_is_still_json) {
    const ScratchDirectory scratch;
    const std::string output = scratch.path("\xE9.hpp");
    EXPECT_THAT(printed("bake " + teapot() + " --name pot --json -o " + output)["output"].get<std::string>(),
                HasSubstr("\uFFFD.hpp"));
}

TEST(CliInfo, names_what_is_needed_and_what_is_not) {
    EXPECT_TRUE(every_term_has_a_name);
    const json object = printed("info " + teapot() + " --json");
    EXPECT_EQ(object["vertices"], 529);
    EXPECT_EQ(object["triangles"], 992);
    EXPECT_EQ(object["materials"], 1);
    const auto has = [](const json& list, const char* name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const char* name : {"depth", "gouraud", "specular", "local_viewer"})
        EXPECT_TRUE(has(object["needs"]["needed"], name)) << name;
    for (const char* name : {"flat", "unlit", "stretch"})
        EXPECT_TRUE(has(object["needs"]["not_paid_for"], name)) << name;
    const json flat = printed("info " + teapot() + " --shading flat --json");
    EXPECT_TRUE(has(flat["needs"]["needed"], "flat"));
    EXPECT_TRUE(has(flat["needs"]["not_paid_for"], "gouraud"));
}

TEST(CliInfo, says_the_same_to_people) {
    const Ran ran = shade16_program("info " + teapot() + " --size 128x64");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.err, IsEmpty());
    for (const char* part : {"529 vertices, 992 triangles, 1 material", "extents: -16.07", "Does not pay for\n  orthographic",
                             "mesh 12300 bytes", "mediump", "8 rows      4096 bytes", "128x64 pixels"})
        EXPECT_THAT(ran.out, HasSubstr(part));
    EXPECT_EQ(shade16_program("info /no/such.obj").exit_code, 2);
}

constexpr Light lights[] = {directional_light({0, 0, 1}), point_light({1, 2, 3})};
constexpr auto ring = torus<12, 6>;
constexpr Object objects[] = {{.mesh = ring.mesh(), .material = *find_material("brass")},
                              {.mesh = ring.mesh(), .material = {.shading = Shading::flat}}};
constexpr Scene scene{.lights = lights, .objects = objects};

template <PrecisionTier Tier>
void expect_memory_as_estimated() {
    constexpr std::size_t padding = 16;
    const auto keep = sizeof(Workspace<scene, Tier>), replay = sizeof(Workspace<scene, Tier, VertexStore::replay>);
    EXPECT_LE(workspace_bytes<Tier>(scene, VertexStore::keep), keep);
    EXPECT_GE(workspace_bytes<Tier>(scene, VertexStore::keep) + padding, keep);
    EXPECT_LE(workspace_bytes<Tier>(scene, VertexStore::replay), replay);
    EXPECT_GE(workspace_bytes<Tier>(scene, VertexStore::replay) + padding, replay);
}

TEST(CliInfo, memory_is_that_of_the_compiled_scene) {
    expect_memory_as_estimated<lowp>();
    expect_memory_as_estimated<mediump>();
    expect_memory_as_estimated<highp>();
    EXPECT_EQ(shininess_bytes<mediump>(scene), sizeof(Shininess<mediump>));  // the flat one has no highlights
    EXPECT_EQ(mesh_bytes(scene), 12u * ring.mesh().positions.count + 6u * ring.mesh().triangles.count);
}

}  // namespace
}  // namespace shade16::host
