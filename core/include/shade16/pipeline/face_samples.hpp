// Faces whose pixels are made one by one: what samples their corners, and what makes pixels of samples.
#pragma once

#include "shade16/pipeline/paint_table.hpp"
#include "shade16/pipeline/raster.hpp"
#include "shade16/pipeline/vertex_light.hpp"

namespace shade16 {

template <Needs N, PrecisionTier Precision, VertexStore Store, Channels Colors>
class FaceSamples : public VertexLight<N, Precision, Store, Colors> {
    using Base = VertexLight<N, Precision, Store, Colors>;

public:
    using typename Base::Tier, typename Base::Vertex;
    using Base::Base;

protected:
    using typename Base::Corners;
    using Base::work_;

    static constexpr bool is_phong(const Material& m) { return N.phong && (!(N.flat || N.gouraud || N.texture) || detail::is_phong(m)); }
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

private:
    using Base::lights_of, Base::normal_of, Base::lit_sample_at, Base::split_face_light;
};

}  // namespace shade16
