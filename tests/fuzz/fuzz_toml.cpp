// Bytes as a scene file: a scene that is drawn, and that is the same when it is written and read again; or a refusal.
#include <algorithm>

#include "host_sim/scene_file/bake_scene.hpp"
#include "host_sim/scene_file/dump_scene.hpp"
#include "host_sim/scene_file/read_scene.hpp"
#include "tests/fuzz/contract.hpp"
#include "tests/fuzz/drawing.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::fuzz {
namespace {

/// Beside the scene, so that it can have a model and pictures.
struct Directory : host::ScratchDirectory {
    Directory() {
        for (const std::string name : {"house.obj", "crate.png", "bricks.png"}) std::filesystem::copy_file(SHADE16_ASSETS "/" + name, path(name));
    }
};

void expect_the_same_again(const host::SceneDescription& description) {
    const std::string dumped = host::dump_scene(description);
    const std::string again = host::dump_scene(host::read_scene_text(dumped, description.path));
    if (dumped != again) break_contract("This scene:\n" + dumped + "\nwas read as this one:\n" + again);
}

void draw(const host::LoadedScene& loaded) {
    constexpr std::size_t most_vertices = 4000, most_lights = 500;
    const Scene& scene = loaded.scene();
    if (host::vertex_count(scene) > most_vertices || scene.objects.count * scene.lights.count > most_lights) return;
    const host::OutputSettings& output = loaded.description().output;
    const std::vector<Pose> poses = loaded.poses(120_deg);
    const Frame frame{.poses = poses.data()};
    const Viewport viewport{std::min(output.size.width, 48), std::min(output.size.height, 32)};
    check_drawing({.scene = &scene, .frame = &frame, .viewport = viewport, .band_rows = std::max(output.band_rows, 1)});
}

}  // namespace
}  // namespace shade16::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace shade16;
    static const fuzz::Directory directory;
    fuzz::is_accepted("scene.toml", [&] {
        const std::string_view text = fuzz::as_text(data, size);
        const host::SceneDescription description = host::read_scene_text(text, directory.path("scene.toml"));
        fuzz::expect_the_same_again(description);
        const host::LoadedScene loaded(description);
        host::bake_scene_header(loaded, "scene");
        fuzz::draw(loaded);
    });
    return 0;
}
