// Preparing a scene and beginning a frame.
#include "check.hpp"
#include "convert.hpp"
#include "renderer.hpp"
#include "terms.hpp"

namespace shade16::c {
namespace {

bool becomes_flat(const shade16_material& m) { return m.shading == SHADE16_SHADING_FLAT && m.unlit == 0; }

Counts counts_of(const shade16_scene& scene) {
    Counts n{scene.object_count, scene.light_count};
    for (uint32_t i = 0; i < scene.object_count; ++i) {
        const shade16_object& object = scene.objects[i];
        n.vertices += object.mesh->vertex_count;
        if (becomes_flat(object.material)) n.flat_faces += object.mesh->triangle_count;
    }
    return n;
}

uint64_t bytes_of(const Counts& counts) {
    Arena arena(nullptr);
    arena.reserve<shade16_renderer>();
    lay_out(arena, counts);
    return arena.bytes();
}

/// The scene as the engine's own, in the renderer's arrays.
void take(shade16_renderer& r, const shade16_scene& scene) {
    for (uint32_t i = 0; i < scene.light_count; ++i) r.arrays.lights[i] = as_light(scene.lights[i]);
    for (uint32_t i = 0; i < scene.object_count; ++i) {
        const shade16_object& from = scene.objects[i];
        r.arrays.objects[i] = {as_mesh(*from.mesh), as_material(from.material), as_pose(from.pose)};
    }
    r.scene = {as_camera(scene.camera), {r.arrays.lights, scene.light_count}, {r.arrays.objects, scene.object_count}, as_rgb(scene.background)};
    r.viewport = {scene.width_px, scene.height_px};
}

/// What the frame varies, into the scene.
void take(shade16_renderer& r, const shade16_frame& frame) {
    if (frame.camera != nullptr) r.scene.camera = as_camera(*frame.camera);
    for (uint32_t i = 0; frame.lights != nullptr && i < r.scene.lights.count; ++i) r.arrays.lights[i] = as_light(frame.lights[i]);
    for (uint32_t i = 0; i < r.scene.objects.count; ++i) {
        Object& object = r.arrays.objects[i];
        if (frame.poses != nullptr) object.pose = as_pose(frame.poses[i]);
        if (frame.materials != nullptr) object.material = as_material(frame.materials[i]);
    }
}

bool shines_on_surfaces(const Scene& scene) {
    for (const Light& light : scene.lights)
        if (light.kind != LightKind::ambient && !light.intensity.is_zero()) return true;
    return false;
}

/// Whether this library has the terms that the scene needs, and the scene the normals.
shade16_status check_terms(const Scene& scene) {
    if (shines_on_surfaces(scene))
        for (const Object& object : scene.objects)
            if (!object.material.unlit && object.material.shading != Shading::flat && object.mesh.normals.empty() && !object.mesh.positions.empty())
                return SHADE16_NO_NORMALS;
    return first_lacking(chosen_terms, needs_of(scene));
}

/// Flattened, so that the compiler computes the bound of the table's error, which is a constant: a call would divide 64 bits. A library
/// without specular light has no call.
[[gnu::flatten, maybe_unused]] void make_kernel(KeptKernel& kept, Q16 exponent) {
    kept.kernel = shininess<Precision>(exponent);
    kept.exponent = exponent.raw;
}

/// Makes the kernels of exponents that were not there in the frame before.
void make_kernels(shade16_renderer& r) {
    if constexpr (chosen_terms.specular)
        for (uint32_t i = 0; i < r.scene.objects.count; ++i) {
            const Material& material = r.scene.objects[i].material;
            KeptKernel& kept = r.arrays.kernels[i];
            r.arrays.kernel_of_object[i] = shade16::detail::has_specular(r.scene, material) ? &kept.kernel : nullptr;
            const Q16 exponent = clamp(material.shininess, min_shininess, max_shininess);
            if (r.arrays.kernel_of_object[i] != nullptr && kept.exponent != exponent.raw) make_kernel(kept, exponent);
        }
}

}  // namespace
}  // namespace shade16::c

using namespace shade16::c;

extern "C" size_t shade16_workspace_bytes(const shade16_scene* scene) {
    if (scene == nullptr || check(*scene) != SHADE16_OK) return 0;
    const uint64_t bytes = bytes_of(counts_of(*scene));
    return bytes > SIZE_MAX ? SIZE_MAX : static_cast<size_t>(bytes);
}

extern "C" shade16_status shade16_init(void* memory, size_t bytes, const shade16_scene* scene, shade16_renderer** renderer) {
    if (renderer != nullptr) *renderer = nullptr;
    if (memory == nullptr || scene == nullptr || renderer == nullptr) return SHADE16_NULL_ARGUMENT;
    if (reinterpret_cast<uintptr_t>(memory) % SHADE16_ALIGNMENT != 0) return SHADE16_MEMORY_MISALIGNED;
    if (const shade16_status status = check(*scene); status != SHADE16_OK) return status;
    const Counts counts = counts_of(*scene);
    if (bytes < bytes_of(counts)) return SHADE16_MEMORY_TOO_SMALL;

    Arena arena(memory);
    unsigned char* const place = arena.reserve<shade16_renderer>();
    auto* const made = new (Here{place}) shade16_renderer(lay_out(arena, counts));
    take(*made, *scene);
    if (const shade16_status status = check_terms(made->scene); status != SHADE16_OK) return status;
    *renderer = made;
    return SHADE16_OK;
}

extern "C" shade16_status shade16_begin(shade16_renderer* renderer, const shade16_frame* frame) {
    if (renderer == nullptr) return SHADE16_NULL_ARGUMENT;
    shade16_renderer& r = *renderer;
    r.is_begun = false;
    const shade16_frame nothing{};
    const shade16_frame& wanted = frame != nullptr ? *frame : nothing;
    shade16_status status = check(wanted, r.scene.lights.count, r.scene.objects.count);
    if (status != SHADE16_OK) return status;
    for (uint32_t i = 0; wanted.materials != nullptr && i < r.scene.objects.count; ++i)
        if (becomes_flat(wanted.materials[i]) != shade16::detail::is_flat(r.scene.objects[i].material)) return SHADE16_FLATNESS_CHANGED;

    take(r, wanted);
    status = check_terms(r.scene);
    if (status != SHADE16_OK) return status;
    make_kernels(r);
    shade16::Frame values;
    values.component = static_cast<shade16::Component>(wanted.component);
    r.pipeline.begin(values, r.viewport);
    r.is_begun = true;
    return SHADE16_OK;
}
