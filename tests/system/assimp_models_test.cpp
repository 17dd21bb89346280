// The OBJ files that Debian's assimp-testmodels has, those that nobody should read among them: each is drawn or refused.
#include <cctype>
#include <cstdio>

#include <gmock/gmock.h>

#include "host_sim/io/png_reader.hpp"
#include "tests/requirements.hpp"
#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

constexpr const char* directories[] = {"/usr/share/assimp/models", "/usr/share/assimp/models-nonbsd"};

bool is_obj(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".obj";
}

/// None if the package is not installed; the second directory is not in every version of it.
std::vector<std::filesystem::path> all_models() {
    std::vector<std::filesystem::path> all;
    for (const char* directory : directories)
        if (std::filesystem::exists(directory))
            for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
                if (entry.is_regular_file() && is_obj(entry.path())) all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

bool shows_something(const Image& image) {
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        if (image.rgb[i] != image.rgb[i % 3]) return true;
    return false;
}

/// A sheet shows from one side alone, so that not every frame of a turn has to show something.
void expect_drawn(const ScratchDirectory& scratch) {
    EXPECT_EQ(scratch.names().size(), 4u);
    bool shows = false;
    for (const std::string& name : scratch.names()) {
        const Image image = read_png(scratch.path(name));
        EXPECT_EQ(image.width, 48);
        EXPECT_EQ(image.height, 36);
        shows = shows || shows_something(image);
    }
    EXPECT_TRUE(shows);
}

void expect_refused(const Ran& ran, const std::filesystem::path& model, const ScratchDirectory& scratch) {
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, testing::StartsWith("shade16: " + model.string()));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
    EXPECT_TRUE(ran.err.ends_with(".\n") || ran.err.ends_with("?\n"));
    EXPECT_THAT(scratch.names(), testing::IsEmpty());
}

TEST(AssimpModels, EachIsDrawnOrRefusedInASentence) {
    if (!has_file(directories[0])) GTEST_SKIP() << "assimp-testmodels is not installed.";
    std::size_t drawn = 0, refused = 0;
    for (const std::filesystem::path& model : all_models()) {
        const ScratchDirectory scratch;
        const Ran ran = shade16_program("render '" + model.string() + "' --size 48x36 --frames 4 -o " + scratch.path("a.png"));
        SCOPED_TRACE(model.string() + "\n" + ran.err);
        if (ran.exit_code == 0) expect_drawn(scratch), ++drawn;
        else expect_refused(ran, model, scratch), ++refused;
    }
    EXPECT_GE(drawn, 17u) << "models that were drawn are refused";
    EXPECT_GE(refused, 8u) << "models that were refused are drawn";
    std::printf("[ assimp   ] %zu models are drawn, %zu refused\n", drawn, refused);
}

}  // namespace
}  // namespace shade16::host
