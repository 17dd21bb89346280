// The gallery: pictures that are shown beside each other differ as much as the page says, and what is committed is what
// today's program draws and measures.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "host_sim/gallery/difference.hpp"
#include "host_sim/gallery/heat_map.hpp"
#include "host_sim/gallery/plate.hpp"
#include "host_sim/gallery/profile.hpp"
#include "host_sim/io/png_reader.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The gallery as it is drawn today, once for all tests.
struct Today {
    ScratchDirectory scratch{};
    Ran ran = shade16_program("gallery '" + (source_directory() / "assets").string() + "' -o " + scratch.path(""));
};
const Today& today() {
    static const Today drawn;
    return drawn;
}

Image plain(int width, int height, uint8_t level) {
    const auto bytes = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<uint8_t>(bytes, level), {}, 0};
}

TEST(Gallery, the_committed_pictures_are_what_the_program_draws) {
    ASSERT_EQ(today().ran.exit_code, 0) << today().ran.err;
    std::vector<std::string> committed;
    for (const auto& entry : std::filesystem::directory_iterator(source_directory() / "docs/gallery"))
        committed.push_back(entry.path().filename().string());
    std::ranges::sort(committed);
    EXPECT_EQ(committed, today().scratch.names()) << "run scripts/gallery.sh";
    std::size_t bytes = 0;
    for (const std::string& name : committed) {
        const std::filesystem::path path = source_directory() / "docs/gallery" / name;
        const Image was = read_png(path.string()), is = read_png(today().scratch.path(name));
        EXPECT_EQ(was.width, is.width);
        EXPECT_TRUE(was.rgb == is.rgb) << "docs/gallery/" << name
                                       << " is stale: run scripts/gallery.sh, and look at it.";
        bytes += std::filesystem::file_size(path);
    }
    EXPECT_LE(bytes, 1'500'000u);
}

TEST(Gallery, the_page_shows_every_picture_and_quotes_the_figures_of_today) {
    const std::string page = text_of(source_directory() / "docs/gallery.md");
    for (const std::string& name : today().scratch.names()) EXPECT_THAT(page, HasSubstr("](gallery/" + name + ")"));
    int rows = 0;
    for (std::size_t at = 0, end; (end = today().ran.out.find('\n', at)) != std::string::npos; at = end + 1) {
        const std::string line = today().ran.out.substr(at, end - at);
        if (!line.starts_with("| ")) continue;
        EXPECT_NE(page.find("\n" + line + "\n"), std::string::npos) << "the page lacks: " << line;
        ++rows;
    }
    EXPECT_GT(rows, 60);
}

TEST(Gallery, pictures_beside_each_other_differ_in_the_share_that_is_stated) {
    const ScratchDirectory scratch;
    const Ran ran =
        shade16_program("gallery --json '" + (source_directory() / "assets").string() + "' -o " + scratch.path(""));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const json object = json::parse(ran.out);
    int pairs = 0;
    for (const json& picture : object["pictures"])
        for (const json& pair : picture["pairs"]) {
            EXPECT_GE(pair["share"], pair["stated_share"]) << pair;
            EXPECT_GT(pair["stated_share"], 0) << "no picture could differ less: " << pair;
            EXPECT_GE(pair["stated_share"].get<double>(), 0.7 * pair["share"].get<double>())
                << "says too little: " << pair;
            ++pairs;
        }
    EXPECT_GE(pairs, 16);
}

// The end of the heat maps' scale is a promise of vertices, which the page says is kept in every scene that it shows.
TEST(Gallery, every_scene_of_it_keeps_every_promise) {
    std::vector<std::filesystem::path> scenes;
    for (const char* name : {"lamps.toml", "textured_cube.toml", "oled.toml"})
        scenes.push_back(source_directory() / "assets/scenes" / name);
    for (const auto& entry : std::filesystem::directory_iterator(source_directory() / "assets/gallery"))
        scenes.push_back(entry.path());
    EXPECT_GE(scenes.size(), 11u);
    for (const auto& scene : scenes) {
        const Ran ran = shade16_program("compare --quiet --frames 1 '" + scene.string() + "'");
        EXPECT_EQ(ran.exit_code, 0) << scene << ran.out << ran.err;
    }
}

TEST(Gallery, what_is_wrong_is_refused) {
    const ScratchDirectory scratch;
    const std::string assets = (source_directory() / "assets").string();
    const Ran no_place = shade16_program("gallery '" + assets + "' -o " + scratch.path("no"));
    EXPECT_EQ(no_place.exit_code, 2);
    EXPECT_THAT(no_place.err, HasSubstr("no: is no directory; expected one that is there, such as docs/gallery."));
    const Ran no_assets = shade16_program("gallery " + scratch.path("no") + " -o " + scratch.path(""));
    EXPECT_EQ(no_assets.exit_code, 2);
    EXPECT_THAT(no_assets.err, HasSubstr("no/gallery/teapot.toml: cannot be opened"));
    EXPECT_EQ(shade16_program("gallery '" + assets + "'").exit_code, 2);
    EXPECT_THAT(scratch.names(), IsEmpty());
}

TEST(Gallery, a_pair_that_differs_too_little_does_not_hold) {
    Plate plate{"a.png", 2, {{"a", plain(4, 2, 10), {}, {}, 1}, {"b", plain(4, 2, 10), {}, {}, 1}}, {}, {}};
    plate.panels[1].image.rgb[4] = 30;  // one pixel of eight
    plate.add_pair("a", "b", 0.125);
    plate.add_pair("a", "b", 0.126);
    EXPECT_TRUE(plate.pairs[0].holds());
    EXPECT_FALSE(plate.pairs[1].holds());
    EXPECT_EQ(plate.pairs[0].difference.largest_levels, 20);
    EXPECT_EQ(plate.pairs[0].difference.mean_levels, 20);
}

TEST(Gallery, heat_maps_run_from_black_to_white_and_show_coverage_in_blue) {
    ReferenceDifference d{.width = 4,
                          .height = 1,
                          .levels = {0, heat_scale_levels / 3, heat_scale_levels * 1.01, 0},
                          .covered_by_one = {false, false, false, true}};
    const std::vector<uint8_t> rgb = heat_map(d).rgb;
    EXPECT_EQ(std::vector<uint8_t>(rgb.begin(), rgb.begin() + 3), (std::vector<uint8_t>{0, 0, 0}));
    EXPECT_EQ(std::vector<uint8_t>(rgb.begin() + 3, rgb.begin() + 6), (std::vector<uint8_t>{255, 0, 0}));
    EXPECT_EQ(std::vector<uint8_t>(rgb.begin() + 6, rgb.begin() + 9), (std::vector<uint8_t>{255, 255, 255}));
    EXPECT_GT(rgb[11], rgb[9]);
    EXPECT_EQ(d.beyond(heat_scale_levels), 1u);
}

TEST(Gallery, a_profile_is_low_where_the_middle_row_is_dark) {
    Image picture = plain(2, 3, 0);
    std::fill_n(picture.rgb.begin() + 9, 3, uint8_t{255});  // the right pixel of the middle row
    const Image profile = profile_of_middle_row(picture, 11);
    const auto is_line = [&](int x, int y) { return profile.rgb[static_cast<std::size_t>(3 * (y * 2 + x))] == 255; };
    EXPECT_TRUE(is_line(0, 10) && !is_line(0, 0));
    for (int y = 0; y < 11; ++y) EXPECT_TRUE(is_line(1, y)) << "the step, from black to white";
}

}  // namespace
}  // namespace shade16::host
