// What is done once a frame: every object's transform, its lights and its tables; and where its vertices are kept.
#pragma once

#include "shade16/pipeline/workspace.hpp"

namespace shade16 {

/// What a pipeline draws: a scene, and for each object its shininess kernel (nullptr without specular light).
template <PrecisionTier Tier>
struct PreparedScene {
    const Scene& scene;
    const Shininess<Tier>* const* shininess;
};

template <Needs N, PrecisionTier Precision, VertexStore Store, Channels Colors>
class FrameSetup {
public:
    using Tier = TierIn<Precision, Colors>;
    using Vertex = ScreenVertex<Tier>;

    constexpr FrameSetup(PreparedScene<Precision> prepared, WorkspaceView<Tier> memory) : prepared_(prepared), work_(memory) {}

    /// Other kernels than the prepared ones, of the caller's memory, one an object: from the next frame on. nullptr: no specular light.
    /// Tables of light are made anew.
    constexpr void use_shininess(const Shininess<Tier>* const* kernels) {
        prepared_.shininess = kernels;
        if constexpr (N.light_table)
            for (uint32_t i = 0; work_.tables != nullptr && i < detail::light_table_count(prepared_.scene); ++i) work_.tables[i].is_made = false;
    }

    /// Begins a frame: sets every object up and, with VertexStore::keep, transforms its vertices.
    constexpr void begin(const Frame& frame, Viewport viewport) {
        const Scene& scene = prepared_.scene;
        viewport_ = viewport;
        Camera camera = frame.camera != nullptr ? *frame.camera : scene.camera;
        if constexpr (!N.orthographic) camera.projection = Projection::perspective;
        if constexpr (!N.perspective) camera.projection = Projection::orthographic;
        const View<Light> lights(frame.lights != nullptr ? frame.lights : scene.lights.first, scene.lights.count);
        const View3 view = make_view(camera, viewport);
        uint32_t first_vertex = 0, first_face = 0, first_split = 0;
        [[maybe_unused]] uint32_t tables = 0;
        for (uint32_t i = 0; i < scene.objects.count; ++i) {
            const Object& object = scene.objects[i];
            const Pose& pose = frame.poses != nullptr ? frame.poses[i] : object.pose;
            ObjectState<Tier>& state = work_.objects[i];
            state.first_vertex = first_vertex, state.first_face = first_face, state.first_split = first_split;
            begin_object(state, object, pose, view, lights, i);
            const Material& material = frame.materials != nullptr ? frame.materials[i] : object.material;
            light_object(state, frame.component, material, object, pose, camera, view, lights);
            if constexpr (N.light_table) state.table = prepare_table(state, frame.component, material, object, pose, camera, view, lights, tables);
            first_vertex += object.mesh.positions.count;
            if (detail::is_flat(object.material)) first_face += object.mesh.triangles.count;
            if constexpr (N.texture)
                if (detail::keeps_split_light(object)) first_split += object.mesh.positions.count;
        }
    }

protected:
    SHADE16_INLINE static constexpr bool transform_vertex(const ViewTransform& t, const Position16& p, Vertex& out) {
        const ClipVertex v = to_clip<N>(t, p);
        const bool inside = is_inside(t, v);
        if (inside) project<N>(t, v, out), out.flags = 0;
        else out.flags = outcode(t, p);
        return inside;
    }

    // With `replay` two corners of one triangle may share a slot, so nobody keeps a reference into the cache: a vertex is
    // copied out, and back once it is lit.
    constexpr Vertex replayed(const Object& object, const ObjectState<Tier>& state, uint32_t index) {
        const uint32_t slot = index & (work_.slots - 1);
        if (work_.tags[slot] != index + 1) {
            work_.tags[slot] = index + 1;
            transform_vertex(state.transform, object.mesh.positions[index], work_.vertices[slot]);
        }
        return work_.vertices[slot];
    }
    constexpr void keep_replayed(uint32_t index, const Vertex& v) {
        const uint32_t slot = index & (work_.slots - 1);
        if (work_.tags[slot] == index + 1) work_.vertices[slot] = v;
    }

    PreparedScene<Precision> prepared_;
    WorkspaceView<Tier> work_;
    Viewport viewport_{};

private:
    constexpr void begin_object(ObjectState<Tier>& state, const Object& object, const Pose& pose, const View3& view, View<Light> lights,
                                uint32_t index) {
        state.transform = make_view_transform(view, pose, object.mesh);
        state.shininess = prepared_.shininess[index];
        state.first_light = index * lights.count;
        if constexpr (Store == VertexStore::keep) {
            state.is_inside = true;
            for (uint32_t i = 0; i < object.mesh.positions.count; ++i)
                if (!transform_vertex(state.transform, object.mesh.positions[i], work_.vertices[state.first_vertex + i])) state.is_inside = false;
            if constexpr (N.flat)
                if (detail::is_flat(object.material))
                    for (uint32_t i = 0; i < object.mesh.triangles.count; ++i) work_.faces[state.first_face + i].is_known = 0;
        }
    }

    constexpr void light_object(ObjectState<Tier>& state, Component shown, const Material& material, const Object& object, const Pose& pose,
                                const Camera& camera, const View3& view, View<Light> lights) {
        state.lighting = make_object_lighting<Tier, N>(camera, view.rotation, lights, material, pose, object.mesh);
        keep_component(state.lighting, shown);
        if constexpr (detail::shapes_lamps(N))
            if (work_.shapes != nullptr) state.lighting.shapes = work_.shapes + state.first_light;
        state.lights = 0;
        if constexpr (N.diffuse || N.specular)
            for (const Light& light : lights) {
                if (material.unlit || light.kind == LightKind::ambient || light.intensity.is_zero()) continue;
                const uint32_t number = state.lights++;
                ObjectLight<Tier>& lit = work_.lights[state.first_light + number];
                lit = make_object_light<Tier, N>(camera, view.rotation, light, material, pose, object.mesh);
                keep_component(lit, shown);
                if constexpr (detail::shapes_lamps(N))
                    if (work_.shapes != nullptr && detail::is_shaped(light)) {
                        work_.shapes[state.first_light + number] = make_lamp_shape(view.rotation, light, pose, object.mesh, lit.point.bits);
                        lit.shape = static_cast<uint16_t>(number + 1);
                    }
            }
    }

    /// The number of the object's light table, if it has one that holds. `tables` counts them.
    constexpr uint8_t prepare_table(const ObjectState<Tier>& state, Component shown, const Material& material, const Object& object, const Pose& pose,
                                    const Camera& camera, const View3& view, View<Light> lights, uint32_t& tables) {
        if (!detail::may_use_light_table(object) || tables == 255) return 0;
        const uint32_t number = ++tables;
        ObjectLight<Tier>* const kept = work_.table_lights + number * lights.count;
        return prepare_light_table<N>(work_.tables[number - 1], kept, work_.table_lights, camera, view.rotation, lights, material, pose, shown, state.shininess)
                   ? static_cast<uint8_t>(number) : uint8_t{0};
    }
};

}  // namespace shade16
