// The pipeline: scene -> transform -> clip -> light -> set-up -> raster -> band. One instantiation for a set of needs and
// a tier, shared by all scenes that need the same. Its parts stand on each other in the order of the data: FrameSetup begins a
// frame, VertexLight lights, FaceSamples samples, Pipeline draws.
#pragma once

#include "shade16/pipeline/clip.hpp"
#include "shade16/pipeline/face_samples.hpp"

namespace shade16 {

template <Needs N, PrecisionTier Precision, VertexStore Store = VertexStore::keep, Channels Colors = Channels::rgb>
class Pipeline : public FaceSamples<N, Precision, Store, Colors> {
    using Base = FaceSamples<N, Precision, Store, Colors>;

public:
    using typename Base::Tier, typename Base::Vertex;
    using Base::Base;

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

private:
    using typename Base::Corners, typename Base::FlatCorners;
    template <class Sample>
    using SampleCorners = typename Base::template SampleCorners<Sample>;
    using Base::prepared_, Base::work_, Base::viewport_, Base::replayed, Base::color_corners;
    using Base::is_by_pixel, Base::copied;

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
        if constexpr (N.flat || N.gouraud) {
            FlatCorners flat;
            const Corners colored = color_corners(object, state, face, v, flat);
            if constexpr (N.flat) triangle.a = colored.a, triangle.b = colored.b, triangle.c = colored.c;
            draw_triangle<Tier::stepping, N.depth>(triangle, band);
        }
    }

    template <PixelFormat Format>
    [[gnu::noinline]] constexpr void draw_by_pixel(const Band<Format>& band, const FacingTriangle<Tier>& triangle, const Object& object,
                                                   const ObjectState<Tier>& state, uint32_t face, Corners v) {
        this->with_samples(object, state, face, v, [&]<class Sample, class Light>(const Sample (&corner)[3], const Light& light) {
            const Triangle t = object.mesh.triangles[face];
            auto samples = copied(corner);
            if constexpr (Light::Kind::by_depth) {
                const auto depth = [&](uint16_t index) { return detail::row_dot(state.transform.row[2], object.mesh.positions[index], state.transform.offset[2]); };
                this->map_by_depth(samples.corner, light.maps, {depth(t.a), depth(t.b), depth(t.c)});
            }
            this->paint_samples(triangle, samples.corner, light, object, band);
        });
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
        if constexpr (N.flat || N.gouraud) {
            FlatCorners flat;
            const Corners colored = color_corners(object, state, face, v, flat);
            for_each_of_fan(band, object, state, face, colored, false, [&](const FacingTriangle<Tier>& triangle, const ClipPolygon<Tier>&, int) {
                draw_triangle<Tier::stepping, N.depth>(triangle, band);
            });
        }
    }
    template <PixelFormat Format>
    constexpr void draw_fan_by_pixel(const Band<Format>& band, const Object& object, const ObjectState<Tier>& state, uint32_t face, Corners v) {
        this->with_samples(object, state, face, v, [&]<class Sample, class Light>(const Sample (&corner)[3], const Light& light) {
            using Kind = typename Light::Kind;
            for_each_of_fan(band, object, state, face, v, true, [&](const FacingTriangle<Tier>& triangle, const ClipPolygon<Tier>& polygon, int i) {
                const auto at = [&](const ClipCorner<Tier>& w) { return mix<Kind>(corner, w.r, w.g, w.b, Vertex::channel_bits); };
                SampleCorners<typename Kind::Sample> samples{{at(polygon.corner[0]), at(polygon.corner[i]), at(polygon.corner[i + 1])}};
                if constexpr (Kind::by_depth)
                    this->map_by_depth(samples.corner, light.maps,
                                 {polygon.corner[0].position.w, polygon.corner[i].position.w, polygon.corner[i + 1].position.w});
                this->paint_samples(triangle, samples.corner, light, object, band);
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
};

}  // namespace shade16
