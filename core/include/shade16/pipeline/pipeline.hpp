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

template <Needs N, PrecisionTier Precision, VertexStore Store = VertexStore::keep, Channels Colors = Channels::rgb>
class Pipeline {
public:
    using Tier = TierIn<Precision, Colors>;
    using Vertex = ScreenVertex<Tier>;

    constexpr Pipeline(PreparedScene<Precision> prepared, WorkspaceView<Tier> memory) : prepared_(prepared), work_(memory) {}

    /// Other kernels than the prepared ones, of the caller's memory, one an object: from the next frame on. nullptr: no specular light.
    constexpr void use_shininess(const Shininess<Tier>* const* kernels) { prepared_.shininess = kernels; }

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

    /// Draws one band of the frame, background included. Bands may come in any order.
    template <PixelFormat Format>
    constexpr void draw(const Band<Format>& band) {
        static_assert(channels_of_format<Format> == Colors,
                      "a grey format is drawn by a pipeline of Channels::luma, and a format of three channels by one of Channels::rgb");
        clear_to(band, prepared_.scene.background);
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
        state.lighting = make_object_lighting<Tier>(camera, view.rotation, lights, material, pose, object.mesh);
        keep_component(state.lighting, shown);
        if constexpr (detail::shapes_lamps(N))
            if (work_.shapes != nullptr) state.lighting.shapes = work_.shapes + state.first_light;
        state.lights = 0;
        if constexpr (N.diffuse || N.specular)
            for (const Light& light : lights) {
                if (material.unlit || light.kind == LightKind::ambient || light.intensity.is_zero()) continue;
                const uint32_t number = state.lights++;
                ObjectLight<Tier>& lit = work_.lights[state.first_light + number];
                lit = make_object_light<Tier>(camera, view.rotation, light, material, pose, object.mesh);
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
                if (!mesh.colors.empty()) factor = as_factor<Colors>(mean_color(mesh.colors[t.a], mesh.colors[t.b], mesh.colors[t.c])), is_given = true;
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
        if constexpr (N.phong || N.texture)
            if (is_by_pixel(object)) return draw_by_pixel(band, triangle, object, state, face, v);
        FlatCorners flat;
        const Corners colored = color_corners(object, state, face, v, flat);
        if constexpr (N.flat) triangle.a = colored.a, triangle.b = colored.b, triangle.c = colored.c;
        draw_triangle<Tier::stepping, N.depth>(triangle, band);
    }

    static constexpr bool is_phong(const Material& m) { return N.phong && (!(N.flat || N.gouraud) || detail::is_phong(m)); }
    /// Its pixels are made one by one, from samples.
    static constexpr bool is_by_pixel(const Object& o) { return is_phong(o.material) || (N.texture && detail::has_texture(o)); }

    /// What samples the object's face and what makes pixels of them: `use(samples at the corners, light)`.
    template <class Use>
    SHADE16_INLINE constexpr void with_samples(const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v, Use use) {
        const Triangle t = object.mesh.triangles[face];
        TextureLookup maps;
        if constexpr (detail::looks_up(N)) maps = TextureLookup(object, state.transform.template is_perspective<N>());
        if constexpr (N.light_table)
            if (state.table != 0) {
                const LightTableMemory<Tier>& table = work_.tables[state.table - 1];
                const TableSample at[3] = {table_sample(table, normal_of(object, state, t.a)), table_sample(table, normal_of(object, state, t.b)),
                                           table_sample(table, normal_of(object, state, t.c))};
                return use(at, TableLight<N, Colors>{table.entry, object.material.light_table == LightTable::bilinear});
            }
        if constexpr (N.phong)
            if (is_phong(object.material)) {
                const SurfaceSample at[3] = {surface_at<N>(object.mesh, state.lighting, t.a), surface_at<N>(object.mesh, state.lighting, t.b),
                                             surface_at<N>(object.mesh, state.lighting, t.c)};
                PixelLight<N, Tier> light{state.lighting, lights_of(state), state.shininess, !object.mesh.colors.empty(), maps, {}};
                if constexpr (N.bump)
                    if (maps.bump != nullptr) light.tangents = face_tangents<N>(object.mesh, t, state.lighting.stretch);
                return use(at, light);
            }
        if constexpr (N.texture) {
            LitSample at[3];
            if (N.flat && detail::is_flat(object.material)) {
                const SplitLightOf<Colors> light = split_face_light(object, state, face);
                at[0] = lit_sample(light, texture_sample_at(object.mesh, t.a));
                at[1] = lit_sample(light, texture_sample_at(object.mesh, t.b));
                at[2] = lit_sample(light, texture_sample_at(object.mesh, t.c));
            } else {
                at[0] = lit_sample_at(object, state, t.a, *v.a), at[1] = lit_sample_at(object, state, t.b, *v.b), at[2] = lit_sample_at(object, state, t.c, *v.c);
            }
            use(at, TexturedLight<N, Colors>{maps});
        }
    }

    /// Texture coordinates become linear on the screen; w are the corners' depths.
    template <class Sample>
    static constexpr void map_by_depth(Sample (&sample)[3], const TextureLookup& maps, const int32_t (&w)[3]) {
        if (!maps.by_depth) return;
        TextureSample at[3] = {sample[0].at, sample[1].at, sample[2].at};
        detail::divide_by_depth(at, w);
        for (int i = 0; i < 3; ++i) sample[i].at = at[i];
    }

    template <PixelFormat Format>
    [[gnu::noinline]] constexpr void draw_by_pixel(const Band<Format>& band, const FacingTriangle<Tier>& triangle, const Object& object,
                                                   const ObjectState<Tier>& state, uint32_t face, Corners v) {
        with_samples(object, state, face, v, [&]<class Sample, class Light>(const Sample (&corner)[3], const Light& light) {
            const Triangle t = object.mesh.triangles[face];
            auto samples = copied(corner);
            if constexpr (Light::Kind::by_depth) {
                const auto depth = [&](uint16_t index) { return detail::row_dot(state.transform.row[2], object.mesh.positions[index], state.transform.offset[2]); };
                map_by_depth(samples.corner, light.maps, {depth(t.a), depth(t.b), depth(t.c)});
            }
            paint_samples(triangle, samples.corner, light, object, band);
        });
    }
    template <class Sample>
    struct SampleCorners {
        Sample corner[3];
    };
    template <class Sample>
    static constexpr SampleCorners<Sample> copied(const Sample (&corner)[3]) { return {{corner[0], corner[1], corner[2]}}; }

    template <class Sample, class Light, PixelFormat Format>
    static constexpr void paint_samples(const FacingTriangle<Tier>& triangle, const Sample (&corner)[3], const Light& light,
                                        [[maybe_unused]] const Object& object, const Band<Format>& band) {
        if constexpr (N.spherical && requires { light.tangents; })
            if (object.material.normal_path == NormalPath::spherical) return draw_spherical(triangle, corner, light, band);
        draw_samples<N.depth>(triangle, corner, light, band);
    }

    constexpr RasterPoint centre() const { return {viewport_.width * 8, viewport_.height * 8}; }
    /// A triangle through the near plane or the guard band: clipped to a fan. It is lit only if some of it shows.
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr void draw_clipped(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face,
                                                  Corners v) {
        const bool by_pixel = is_by_pixel(object);
        bool shows = false;
        for_each_of_fan(band, object, state, face, v, by_pixel, [&](const FacingTriangle<Tier>&, const ClipPolygon<Tier>&, int) { shows = true; });
        if (!shows) return;
        if constexpr (N.phong || N.texture)
            if (by_pixel) return draw_fan_by_pixel(band, object, state, face, v);
        FlatCorners flat;
        const Corners colored = color_corners(object, state, face, v, flat);
        for_each_of_fan(band, object, state, face, colored, false, [&](const FacingTriangle<Tier>& triangle, const ClipPolygon<Tier>&, int) {
            draw_triangle<Tier::stepping, N.depth>(triangle, band);
        });
    }
    template <PixelFormat Format>
    constexpr void draw_fan_by_pixel(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v) {
        with_samples(object, state, face, v, [&]<class Sample, class Light>(const Sample (&corner)[3], const Light& light) {
            using Kind = typename Light::Kind;
            for_each_of_fan(band, object, state, face, v, true, [&](const FacingTriangle<Tier>& triangle, const ClipPolygon<Tier>& polygon, int i) {
                const auto at = [&](const ClipCorner<Tier>& w) { return mix<Kind>(corner, w.r, w.g, w.b, Vertex::channel_bits); };
                SampleCorners<typename Kind::Sample> samples{{at(polygon.corner[0]), at(polygon.corner[i]), at(polygon.corner[i + 1])}};
                if constexpr (Kind::by_depth)
                    map_by_depth(samples.corner, light.maps,
                                 {polygon.corner[0].position.w, polygon.corner[i].position.w, polygon.corner[i + 1].position.w});
                paint_samples(triangle, samples.corner, light, object, band);
            });
        });
    }

    /// `use(triangle, polygon, i)` for each triangle of the clipped fan that shows: corners 0, i and i + 1 of the polygon.
    template <PixelFormat Format, class Use>
    constexpr void for_each_of_fan(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v, bool by_pixel,
                                   Use use) {
        const ClipPolygon<Tier> polygon = clip(state.transform, polygon_of(object, state, face, v, by_pixel));
        const auto corner = [&](int i) {
            Vertex out;
            project(state.transform, polygon.corner[i].position, out);
            if constexpr (Colors == Channels::luma) out.luma = polygon.corner[i].r;
            else out.r = polygon.corner[i].r, out.g = polygon.corner[i].g, out.b = polygon.corner[i].b;
            return out;
        };
        for (int i = 1; i + 1 < polygon.count; ++i) {
            const Vertex fan[3] = {corner(0), corner(i), corner(i + 1)};
            const FacingTriangle<Tier> triangle(fan[0], fan[1], fan[2], centre(), band.first_row, band.rows);
            if (doubled_area(fan[0], fan[1], fan[2]) < 0 && triangle.shows(viewport_.width)) use(triangle, polygon, i);
        }
    }

    /// A triangle to be clipped. Pixel by pixel the channels are not colours but the corners' own weights.
    constexpr ClipPolygon<Tier> polygon_of(const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v, bool by_pixel) {
        const Triangle t = object.mesh.triangles[face];
        ClipPolygon<Tier> polygon;
        const auto add = [&](uint16_t index, const Vertex& corner, int number) {
            const auto weight = [&](int of) { return static_cast<typename Vertex::Channel>(number == of ? uint32_t{1} << Vertex::channel_bits : 0); };
            const ClipVertex position = to_clip(state.transform, object.mesh.positions[index]);
            if (by_pixel) polygon.add({position, weight(0), weight(1), weight(2)});
            else if constexpr (Colors == Channels::luma) polygon.add({position, corner.luma, 0, 0});
            else polygon.add({position, corner.r, corner.g, corner.b});
        };
        add(t.a, *v.a, 0), add(t.b, *v.b, 1), add(t.c, *v.c, 2);
        return polygon;
    }

    PreparedScene<Precision> prepared_;
    WorkspaceView<Tier> work_;
    Viewport viewport_{};
};

}  // namespace shade16
