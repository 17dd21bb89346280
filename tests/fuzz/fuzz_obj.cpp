// Bytes as an OBJ file: a model that is quantised, fitted and drawn, or a refusal.
#include "firmware/runtime/fnv1a.hpp"
#include "host_sim/engine/fit.hpp"
#include "host_sim/model/obj_import.hpp"
#include "tests/fuzz/contract.hpp"
#include "tests/fuzz/drawing.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::fuzz {
namespace {

constexpr std::size_t most_triangles = 2000;

/// As a turntable begins, without the fit of camera and light.
void draw(const host::BakedModel& baked) {
    const Q16 scale = host::fitting_scale(baked);
    std::vector<Object> objects;
    for (std::size_t i = 0; i < baked.parts.size(); ++i) {
        const Mesh mesh = host::mesh_of(baked, i);
        objects.push_back({mesh, baked.parts[i].material, centred_pose(mesh, rotate_y(30_deg), scale)});
    }
    const std::vector<Light> lights = host::light_rig();
    Scene scene{.camera = {.eye = {0, 1, 4}, .viewer = Viewer::local}};
    scene.lights = {lights.data(), static_cast<uint32_t>(lights.size())};
    scene.objects = {objects.data(), static_cast<uint32_t>(objects.size())};
    const Frame frame{};
    check_drawing({.scene = &scene, .frame = &frame, .viewport = {32, 24}, .band_rows = 7});
}

/// The fit draws a hundred frames: too many for every file.
bool is_fitted(const uint8_t* data, std::size_t size) {
    Fnv1a hash;
    for (std::size_t i = 0; i < size; ++i) hash.add(data[i]);
    return (hash.value >> 16) % 64 == 0;
}

}  // namespace
}  // namespace shade16::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    using namespace shade16;
    static const host::ScratchDirectory scratch;
    fuzz::is_accepted("model.obj", [&] {
        const auto crease = size % 2 == 0 ? std::optional<double>(40) : std::nullopt;
        const host::Model model = host::import_obj(scratch.write("model.obj", fuzz::as_text(data, size)), crease, size % 3 == 0);
        const host::BakedModel baked = host::quantize(model);
        if (baked.triangle_count() > fuzz::most_triangles) return;
        fuzz::draw(baked);
        if (fuzz::is_fitted(data, size)) host::ModelScene(model, {32, 24});
    });
    return 0;
}
