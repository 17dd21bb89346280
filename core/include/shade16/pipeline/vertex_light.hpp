// Light where a mesh has it: at vertices, each lit at most once a frame, and at the centres of flat faces.
#pragma once

#include "shade16/pipeline/face.hpp"
#include "shade16/pipeline/frame_setup.hpp"
#include "shade16/pipeline/paint_textured.hpp"

namespace shade16 {

template <Needs N, PrecisionTier Precision, VertexStore Store, Channels Colors>
class VertexLight : public FrameSetup<N, Precision, Store, Colors> {
    using Base = FrameSetup<N, Precision, Store, Colors>;

public:
    using typename Base::Tier, typename Base::Vertex;
    using Base::Base;

    /// A vertex as it was transformed, lit now if no triangle did so before: for tests and comparisons.
    constexpr Vertex lit_vertex(uint32_t object, uint32_t index) {
        const Object& of = prepared_.scene.objects[object];
        const ObjectState<Tier>& state = work_.objects[object];
        if constexpr (Store == VertexStore::keep) {
            light_vertex(of, state, index, work_.vertices[state.first_vertex + index]);
            return work_.vertices[state.first_vertex + index];
        }
        Vertex v = replayed(of, state, index);
        light_vertex(of, state, index, v);
        return v;
    }
    /// The same for a face of a flat object.
    constexpr FaceColor<Tier> lit_face(uint32_t object, uint32_t face) {
        return light_face(prepared_.scene.objects[object], work_.objects[object], face);
    }

protected:
    using Base::prepared_, Base::work_, Base::replayed, Base::keep_replayed;

    constexpr View<ObjectLight<Tier>> lights_of(const ObjectState<Tier>& state) const {
        return {work_.lights + state.first_light, state.lights};
    }
    /// The vertex colour, if there is one.
    struct VertexFactor {
        FactorIn<Colors> factor{};
        bool is_given = false;

        constexpr VertexFactor(const Mesh& mesh, uint32_t index) {
            if constexpr (N.vertex_colors)
                if (!mesh.colors.empty()) factor = as_factor<Colors>(mesh.colors[index]), is_given = true;
        }
        constexpr VertexFactor(const Mesh& mesh, const Triangle& t) {
            if constexpr (N.vertex_colors)
                if (!mesh.colors.empty()) factor = as_factor<Colors>(mean_factor(mesh.colors[t.a], mesh.colors[t.b], mesh.colors[t.c])), is_given = true;
        }
        constexpr const FactorIn<Colors>* get() const { return N.vertex_colors && is_given ? &factor : nullptr; }
    };

    [[gnu::noinline]] constexpr void light_vertex(const Object& object, const ObjectState<Tier>& state, uint32_t index, Vertex& v) {
        if (v.flags & is_lit) return;
        if constexpr (N.texture)
            if (detail::keeps_split_light(object)) return keep_split_light(object, state, index, v);
        const VertexFactor factor(object.mesh, index);
        if (N.unlit && (!N.lit || object.material.unlit)) {
            AccumulatorOf<Colors> sum = state.lighting.base;
            if constexpr (N.vertex_colors)
                if (factor.get() != nullptr) detail::modulate(sum, *factor.get());
            v.set_color(sum);
        } else {
            const Position16 p = object.mesh.positions[index];
            v.set_color(light_point<N>(state.lighting, lights_of(state), state.shininess, {raw(p), 1}, normal_of(object, state, index), factor.get()));
        }
        if constexpr (Store == VertexStore::replay) keep_replayed(index, v);
    }
    static constexpr UnitVector<Tier> normal_of(const Object& object, const ObjectState<Tier>& state, uint32_t index) {
        return object.mesh.normals.empty() ? UnitVector<Tier>{} : lighting_normal<N>(state.lighting, object.mesh.normals[index]);
    }

    /// A textured vertex's light, of which the texture is a factor later.
    constexpr SplitLightOf<Colors> split_light(const Object& object, const ObjectState<Tier>& state, uint32_t index) {
        const VertexFactor factor(object.mesh, index);
        const View<ObjectLight<Tier>> lights = object.material.unlit ? View<ObjectLight<Tier>>{} : lights_of(state);
        return split_light_point<N>(state.lighting, lights, state.shininess, {raw(object.mesh.positions[index]), 1}, normal_of(object, state, index), factor.get());
    }
    constexpr void keep_split_light(const Object& object, const ObjectState<Tier>& state, uint32_t index, Vertex& v) {
        const SplitLightOf<Colors> light = split_light(object, state, index);
        if constexpr (Store == VertexStore::keep) work_.split[state.first_split + index] = light;
        AccumulatorOf<Colors> sum = light.body;
        detail::accumulate(sum, light.shine);
        v.set_color(sum);
        if constexpr (Store == VertexStore::replay) keep_replayed(index, v);
    }
    constexpr LitSample lit_sample_at(const Object& object, const ObjectState<Tier>& state, uint32_t index, Vertex& v) {
        const TextureSample at = texture_sample_at(object.mesh, index);
        if constexpr (Store == VertexStore::replay) return lit_sample(split_light(object, state, index), at);
        light_vertex(object, state, index, v);
        return lit_sample(work_.split[state.first_split + index], at);
    }

    constexpr FaceColor<Tier> light_face(const Object& object, const ObjectState<Tier>& state, uint32_t face) {
        if (Store == VertexStore::keep && work_.faces[state.first_face + face].is_known) return work_.faces[state.first_face + face];
        const Triangle t = object.mesh.triangles[face];
        const auto& p = object.mesh.positions;
        const VertexFactor factor(object.mesh, t);
        Vertex lit;
        lit.set_color(light_point<N>(state.lighting, lights_of(state), state.shininess, face_centre(p[t.a], p[t.b], p[t.c]),
                                     lighting_face_normal<N>(state.lighting, p[t.a], p[t.b], p[t.c]), factor.get()));
        FaceColor<Tier> color;
        for_each_channel<Colors>([](auto& to, auto from) { to = from; }, color, lit);
        color.is_known = 1;
        if (Store == VertexStore::keep) work_.faces[state.first_face + face] = color;
        return color;
    }
    constexpr SplitLightOf<Colors> split_face_light(const Object& object, const ObjectState<Tier>& state, uint32_t face) {
        const Triangle t = object.mesh.triangles[face];
        const auto& p = object.mesh.positions;
        const VertexFactor factor(object.mesh, t);
        return split_light_point<N>(state.lighting, lights_of(state), state.shininess, face_centre(p[t.a], p[t.b], p[t.c]),
                                    lighting_face_normal<N>(state.lighting, p[t.a], p[t.b], p[t.c]), factor.get());
    }

    struct Corners {
        Vertex *a, *b, *c;
    };
    /// The corners with their colours: lit in place, or, where the face is flat, in copies that the caller keeps.
    struct FlatCorners {
        Vertex v[N.flat ? 3 : 1];
    };
    constexpr Corners color_corners(const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v, FlatCorners& flat) {
        if constexpr (N.flat)
            if (!N.gouraud || detail::is_flat(object.material)) {
                const FaceColor<Tier> color = light_face(object, state, face);
                flat.v[0] = *v.a, flat.v[1] = *v.b, flat.v[2] = *v.c;
                for (Vertex& corner : flat.v) for_each_channel<Colors>([](auto& to, auto from) { to = from; }, corner, color);
                return {&flat.v[0], &flat.v[1], &flat.v[2]};
            }
        if ((v.a->flags & v.b->flags & v.c->flags & is_lit) == 0) light_corners(object, state, object.mesh.triangles[face], v);
        return v;
    }
    [[gnu::noinline]] constexpr void light_corners(const Object& object, const ObjectState<Tier>& state, const Triangle& t, Corners v) {
        if ((v.a->flags & is_lit) == 0) light_vertex(object, state, t.a, *v.a);
        if ((v.b->flags & is_lit) == 0) light_vertex(object, state, t.b, *v.b);
        if ((v.c->flags & is_lit) == 0) light_vertex(object, state, t.c, *v.c);
    }
};

}  // namespace shade16
