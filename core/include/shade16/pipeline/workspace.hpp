// Workspace: the RAM of a frame. All of it is the caller's, and its size is known at compile time.
#pragma once

#include "shade16/pipeline/light_table.hpp"
#include "shade16/pipeline/transform.hpp"

namespace shade16 {

/// keep: every vertex is transformed once a frame and lit at most once, however many bands there are.
/// replay: a small cache; each band transforms and lights again what it uses. The bits are the same.
enum class VertexStore : uint8_t { keep, replay };

/// What one object needs for a frame.
template <PrecisionTier Tier>
struct ObjectState {
    ViewTransform transform{};
    ObjectLighting<Tier> lighting{};
    const Shininess<Tier>* shininess = nullptr;  // nullptr: no specular light
    uint32_t first_vertex = 0, first_face = 0, first_split = 0;
    uint32_t first_light = 0, lights = 0;
    uint8_t table = 0;       // its light table's number, from 1, where it holds in this frame
    bool is_inside = false;  // every kept vertex is: nothing of the object needs clipping
};

/// A flat face's colour, once it is lit.
template <PrecisionTier Tier>
struct FaceColor {
    typename ScreenVertex<Tier>::Channel r = 0, g = 0, b = 0;
    uint16_t is_known = 0;
};

template <PrecisionTier Tier>
    requires(channels_of<Tier> == Channels::luma)
struct FaceColor<Tier> {
    typename ScreenVertex<Tier>::Channel luma = 0;
    uint16_t is_known = 0;
};

/// The arrays as the pipeline sees them.
template <PrecisionTier Tier>
struct WorkspaceView {
    ObjectState<Tier>* objects = nullptr;
    ObjectLight<Tier>* lights = nullptr;    // objects * lights
    ScreenVertex<Tier>* vertices = nullptr;  // all of them, or `slots`
    FaceColor<Tier>* faces = nullptr;       // one a face of a flat object; with `replay` none
    SplitLightOf<channels_of<Tier>>* split = nullptr;            // one a vertex of an object with textured Gouraud shading; with `replay` none
    uint32_t* tags = nullptr;               // with `replay`: which vertex a slot holds, plus one
    uint32_t slots = 0;                     // with `replay`: a power of two
    LightTableMemory<Tier>* tables = nullptr;    // one an object with a light table
    ObjectLight<Tier>* table_lights = nullptr;   // (tables + 1) * lights: what each was made of, and room to compare
    LampShape* shapes = nullptr;            // objects * lights, where lamps have a range, a falloff or a cone
};

namespace detail {
constexpr uint32_t vertex_count(const Scene& scene) {
    uint32_t n = 0;
    for (const Object& object : scene.objects) n += object.mesh.positions.count;
    return n;
}
constexpr uint32_t flat_face_count(const Scene& scene) {
    uint32_t n = 0;
    for (const Object& object : scene.objects)
        if (is_flat(object.material)) n += object.mesh.triangles.count;
    return n;
}
/// Whether its pixels are made one by one of light that was computed at its vertices.
constexpr bool keeps_split_light(const Object& o) { return has_texture(o) && !is_phong(o.material) && !is_flat(o.material); }
constexpr uint32_t split_light_count(const Scene& scene) {
    uint32_t n = 0;
    for (const Object& object : scene.objects)
        if (keeps_split_light(object)) n += object.mesh.positions.count;
    return n;
}

constexpr uint32_t light_table_count(const Scene& scene) {
    uint32_t n = 0;
    for (const Object& object : scene.objects) n += may_use_light_table(object);
    return n;
}
constexpr uint32_t table_light_count(const Scene& scene) {
    const uint32_t tables = light_table_count(scene);
    return tables == 0 ? 0 : (tables + 1) * scene.lights.count;
}

/// An array that takes no room where it is empty.
template <class T, uint32_t N>
struct Storage {
    T elements[N]{};
    constexpr T* first() { return elements; }
};
template <class T>
struct Storage<T, 0> {
    constexpr T* first() { return nullptr; }
};

constexpr uint32_t at_least_one(uint32_t n) { return n == 0 ? 1 : n; }
}  // namespace detail

/// How many vertices the cache of VertexStore::replay has room for, unless somebody says so.
inline constexpr uint32_t usual_slots = 64;

/// The memory for a scene that is known to the compiler.
template <const Scene& scene, PrecisionTier Precision, VertexStore Store = VertexStore::keep, uint32_t Slots = usual_slots,
          Channels Colors = Channels::rgb>
struct Workspace {
    static_assert((Slots & (Slots - 1)) == 0, "the replay cache has a power of two of slots");
    using Tier = TierIn<Precision, Colors>;
    static constexpr bool keeps = Store == VertexStore::keep;

    ObjectState<Tier> objects[detail::at_least_one(scene.objects.count)]{};
    ObjectLight<Tier> lights[detail::at_least_one(scene.objects.count * scene.lights.count)]{};
    ScreenVertex<Tier> vertices[keeps ? detail::at_least_one(detail::vertex_count(scene)) : Slots]{};
    FaceColor<Tier> faces[keeps ? detail::at_least_one(detail::flat_face_count(scene)) : 1]{};
    [[no_unique_address]] detail::Storage<SplitLightOf<Colors>, keeps ? detail::split_light_count(scene) : 0> split{};
    [[no_unique_address]] detail::Storage<LightTableMemory<Tier>, detail::light_table_count(scene)> tables{};
    [[no_unique_address]] detail::Storage<ObjectLight<Tier>, detail::table_light_count(scene)> table_lights{};
    uint32_t tags[keeps ? 1 : Slots]{};
    [[no_unique_address]] detail::Storage<LampShape, detail::shapes_lamps(needs_of(scene)) ? scene.objects.count * scene.lights.count : 0> shapes{};

    constexpr WorkspaceView<Tier> view() {
        return {objects, lights, vertices, keeps ? faces : nullptr, split.first(), tags, Slots, tables.first(), table_lights.first(), shapes.first()};
    }
};

}  // namespace shade16
