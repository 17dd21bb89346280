// The pipeline: scene -> transform -> clip -> light -> set-up -> raster -> band. One instantiation for a set of needs and
// a tier, shared by all scenes that need the same.
#pragma once

#include "shade16/pipeline/clip.hpp"
#include "shade16/pipeline/face.hpp"
#include "shade16/pipeline/raster.hpp"
#include "shade16/pipeline/workspace.hpp"

namespace shade16 {

/// What a pipeline draws: a scene, and for each object its shininess kernel (nullptr without specular light).
template <PrecisionTier Tier>
struct PreparedScene {
    const Scene& scene;
    const Shininess<Tier>* const* shininess;
};

template <Needs N, PrecisionTier Tier, VertexStore Store = VertexStore::keep>
class Pipeline {
public:
    using Vertex = ScreenVertex<Tier>;

    constexpr Pipeline(PreparedScene<Tier> prepared, WorkspaceView<Tier> memory) : prepared_(prepared), work_(memory) {}

    /// Begins a frame: sets every object up and, with VertexStore::keep, transforms its vertices.
    constexpr void begin(const Frame& frame, Viewport viewport) {
        const Scene& scene = prepared_.scene;
        viewport_ = viewport;
        Camera camera = frame.camera != nullptr ? *frame.camera : scene.camera;
        if constexpr (!N.orthographic) camera.projection = Projection::perspective;
        if constexpr (!N.perspective) camera.projection = Projection::orthographic;
        const View<Light> lights(frame.lights != nullptr ? frame.lights : scene.lights.first, scene.lights.count);
        const View3 view = make_view(camera, viewport);
        uint32_t first_vertex = 0, first_face = 0;
        for (uint32_t i = 0; i < scene.objects.count; ++i) {
            const Object& object = scene.objects[i];
            const Pose& pose = frame.poses != nullptr ? frame.poses[i] : object.pose;
            ObjectState<Tier>& state = work_.objects[i];
            state.first_vertex = first_vertex, state.first_face = first_face;
            begin_object(state, object, pose, camera, view, lights, i);
            first_vertex += object.mesh.positions.count;
            if (detail::is_flat(object.material)) first_face += object.mesh.triangles.count;
        }
    }

    /// Draws one band of the frame, background included. Bands may come in any order.
    template <PixelFormat Format>
    constexpr void draw(const Band<Format>& band) {
        clear(band, nearest_pixel<Format>(prepared_.scene.background));
        for (uint32_t i = 0; i < prepared_.scene.objects.count; ++i) {
            const Object& object = prepared_.scene.objects[i];
            if constexpr (Store == VertexStore::replay)
                for (uint32_t slot = 0; slot < work_.slots; ++slot) work_.tags[slot] = 0;
            draw_object(band, object, work_.objects[i]);
        }
    }

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

private:
    constexpr void begin_object(ObjectState<Tier>& state, const Object& object, const Pose& pose, const Camera& camera, const View3& view,
                                View<Light> lights, uint32_t index) {
        state.transform = make_view_transform(view, pose, object.mesh);
        state.shininess = prepared_.shininess[index];
        state.lighting = make_object_lighting<Tier>(camera, view.rotation, lights, object.material, pose, object.mesh);
        state.first_light = index * lights.count;
        state.lights = 0;
        if constexpr (N.diffuse || N.specular)
            for (const Light& light : lights) {
                if (object.material.unlit || light.kind == LightKind::ambient || light.intensity.is_zero()) continue;
                work_.lights[state.first_light + state.lights++] =
                    make_object_light<Tier>(camera, view.rotation, light, object.material, pose, object.mesh);
            }
        if constexpr (Store == VertexStore::keep) {
            state.is_inside = true;
            for (uint32_t i = 0; i < object.mesh.positions.count; ++i)
                if (!transform_vertex(state.transform, object.mesh.positions[i], work_.vertices[state.first_vertex + i])) state.is_inside = false;
            if constexpr (N.flat)
                if (detail::is_flat(object.material))
                    for (uint32_t i = 0; i < object.mesh.triangles.count; ++i) work_.faces[state.first_face + i].is_known = 0;
        }
    }

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

    constexpr View<ObjectLight<Tier>> lights_of(const ObjectState<Tier>& state) const {
        return {work_.lights + state.first_light, state.lights};
    }
    static constexpr const Rgb* color_of(const Mesh& mesh, uint32_t index) { return mesh.colors.empty() ? nullptr : &mesh.colors[index]; }

    [[gnu::noinline]] constexpr void light_vertex(const Object& object, const ObjectState<Tier>& state, uint32_t index, Vertex& v) {
        if (v.flags & is_lit) return;
        const Rgb* const color = color_of(object.mesh, index);
        if (N.unlit && (!N.lit || object.material.unlit)) {
            Accumulator sum = state.lighting.base;
            if constexpr (N.vertex_colors)
                if (color != nullptr) detail::modulate(sum, *color);
            v.set_color(sum);
        } else {
            const Position16 p = object.mesh.positions[index];
            const UnitVector<Tier> normal =
                object.mesh.normals.empty() ? UnitVector<Tier>{} : lighting_normal<N>(state.lighting, object.mesh.normals[index]);
            v.set_color(light_point<N>(state.lighting, lights_of(state), state.shininess, {raw(p), 1}, normal, color));
        }
        if constexpr (Store == VertexStore::replay) keep_replayed(index, v);
    }

    constexpr FaceColor<Tier> light_face(const Object& object, const ObjectState<Tier>& state, uint32_t face) {
        if (Store == VertexStore::keep && work_.faces[state.first_face + face].is_known) return work_.faces[state.first_face + face];
        const Triangle t = object.mesh.triangles[face];
        const auto& p = object.mesh.positions;
        const auto& c = object.mesh.colors;
        Rgb mean{};
        if (!c.empty()) mean = mean_color(c[t.a], c[t.b], c[t.c]);
        Vertex lit;
        lit.set_color(light_point<N>(state.lighting, lights_of(state), state.shininess, face_centre(p[t.a], p[t.b], p[t.c]),
                                     lighting_face_normal<N>(state.lighting, p[t.a], p[t.b], p[t.c]), c.empty() ? nullptr : &mean));
        const FaceColor<Tier> color{lit.r, lit.g, lit.b, 1};
        if (Store == VertexStore::keep) work_.faces[state.first_face + face] = color;
        return color;
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
                for (Vertex& corner : flat.v) corner.r = color.r, corner.g = color.g, corner.b = color.b;
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

    template <PixelFormat Format>
    constexpr void draw_object(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state) {
        const Triangle* const triangles = object.mesh.triangles.first;
        const uint32_t count = object.mesh.triangles.count;
        Vertex* const kept = work_.vertices + state.first_vertex;
        for (uint32_t face = 0; face < count; ++face) {
            const Triangle t = triangles[face];
            if constexpr (Store == VertexStore::keep) {
                draw_face(band, object, state, face, {kept + t.a, kept + t.b, kept + t.c});
            } else {
                Vertex v[3] = {replayed(object, state, t.a), replayed(object, state, t.b), replayed(object, state, t.c)};
                draw_face(band, object, state, face, {&v[0], &v[1], &v[2]});
            }
        }
    }

    template <PixelFormat Format>
    SHADE16_INLINE constexpr void draw_face(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v) {
        if (!state.is_inside && (v.a->flags | v.b->flags | v.c->flags) & outside_any) {
            if ((v.a->flags & v.b->flags & v.c->flags & outside_any) == 0) draw_clipped(band, object, state, face, v);
            return;
        }
        if (doubled_area(*v.a, *v.b, *v.c) >= 0) return;  // facing away, or edge on
        draw_facing(band, object, state, face, v);
    }

    template <PixelFormat Format>
    [[gnu::noinline]] constexpr void draw_facing(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v) {
        FacingTriangle<Tier> triangle(*v.a, *v.b, *v.c, centre(), band.first_row, band.rows);
        if (!triangle.shows(viewport_.width)) return;
        if constexpr (N.phong)
            if (is_phong(object.material)) {
                SurfaceSample surface[3];
                surface_of(object, state, face, surface);
                return paint_phong(triangle, surface, object, state, band);
            }
        FlatCorners flat;
        const Corners colored = color_corners(object, state, face, v, flat);
        if constexpr (N.flat) triangle.a = colored.a, triangle.b = colored.b, triangle.c = colored.c;
        draw_triangle<Tier::stepping, N.depth>(triangle, band);
    }

    static constexpr bool is_phong(const Material& m) { return N.phong && (!(N.flat || N.gouraud) || detail::is_phong(m)); }
    static constexpr void surface_of(const Object& object, const ObjectState<Tier>& state, uint32_t face, SurfaceSample (&out)[3]) {
        const Triangle t = object.mesh.triangles[face];
        out[0] = surface_at<N>(object.mesh, state.lighting, t.a);
        out[1] = surface_at<N>(object.mesh, state.lighting, t.b);
        out[2] = surface_at<N>(object.mesh, state.lighting, t.c);
    }
    template <PixelFormat Format>
    constexpr void paint_phong(const FacingTriangle<Tier>& triangle, const SurfaceSample (&surface)[3], const Object& object, const ObjectState<Tier>& state,
                               const Band<Format>& band) {
        draw_phong(triangle, surface, PixelLight<N, Tier>{state.lighting, lights_of(state), state.shininess, !object.mesh.colors.empty()},
                   object.material.normal_path, band);
    }

    constexpr RasterPoint centre() const { return {viewport_.width * 8, viewport_.height * 8}; }
    /// A triangle through the near plane or the guard band: clipped to a fan. It is lit only if some of it shows.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr void draw_clipped(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face,
                                                  Corners v) {
        if (!draw_fan<false>(band, object, state, face, v)) return;
        FlatCorners flat;
        draw_fan<true>(band, object, state, face, is_phong(object.material) ? v : color_corners(object, state, face, v, flat));
    }

    template <bool Paint, PixelFormat Format>
    constexpr bool draw_fan(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v) {
        const bool by_pixel = is_phong(object.material);
        ClipPolygon<Tier> polygon = polygon_of(object, state, face, v, by_pixel);
        polygon = clip(state.transform, polygon);
        SurfaceSample surface[N.phong ? 3 : 1];
        if constexpr (N.phong && Paint)
            if (by_pixel) surface_of(object, state, face, surface);

        Vertex fan[3];
        const auto corner = [&](int i) {
            Vertex out;
            project(state.transform, polygon.corner[i].position, out);
            out.r = polygon.corner[i].r, out.g = polygon.corner[i].g, out.b = polygon.corner[i].b;
            return out;
        };
        bool shows = false;
        for (int i = 1; i + 1 < polygon.count; ++i) {
            fan[0] = corner(0), fan[1] = corner(i), fan[2] = corner(i + 1);
            const FacingTriangle<Tier> triangle(fan[0], fan[1], fan[2], centre(), band.first_row, band.rows);
            if (doubled_area(fan[0], fan[1], fan[2]) >= 0 || !triangle.shows(viewport_.width)) continue;
            shows = true;
            if constexpr (!Paint) continue;
            if constexpr (N.phong)
                if (by_pixel) {
                    const auto at = [&](const Vertex& w) { return mix<N>(surface, w.r, w.g, w.b, Vertex::channel_bits); };
                    const SurfaceSample corners[3] = {at(fan[0]), at(fan[1]), at(fan[2])};
                    paint_phong(triangle, corners, object, state, band);
                    continue;
                }
            draw_triangle<Tier::stepping, N.depth>(triangle, band);
        }
        return shows;
    }

    /// A triangle to be clipped. With Phong shading the channels are not colours but the corners' own weights.
    constexpr ClipPolygon<Tier> polygon_of(const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v, bool by_pixel) {
        const Triangle t = object.mesh.triangles[face];
        ClipPolygon<Tier> polygon;
        const auto add = [&](uint16_t index, const Vertex& corner, int number) {
            const auto weight = [&](int of) { return static_cast<typename Vertex::Channel>(number == of ? uint32_t{1} << Vertex::channel_bits : 0); };
            const ClipVertex position = to_clip(state.transform, object.mesh.positions[index]);
            if (by_pixel) polygon.add({position, weight(0), weight(1), weight(2)});
            else polygon.add({position, corner.r, corner.g, corner.b});
        };
        add(t.a, *v.a, 0), add(t.b, *v.b, 1), add(t.c, *v.c, 2);
        return polygon;
    }

    PreparedScene<Tier> prepared_;
    WorkspaceView<Tier> work_;
    Viewport viewport_{};
};

}  // namespace shade16
