// Renderer: a scene that the compiler knows, drawn by the smallest pipeline that covers it.
#pragma once

#include "shade16/pipeline/pipeline.hpp"
#include "shade16/target/sink.hpp"

namespace shade16 {

namespace detail {
constexpr bool has_specular(const Scene& scene, const Material& m) {
    if (m.unlit || m.specular == black) return false;
    for (const Light& light : scene.lights)
        if (light.kind != LightKind::ambient && light.specular != black && !light.intensity.is_zero()) return true;
    return false;
}

/// The index of the first object with this object's exponent, among those with specular light.
constexpr uint32_t first_with_same_shininess(const Scene& scene, uint32_t object) {
    for (uint32_t i = 0; i < object; ++i)
        if (has_specular(scene, scene.objects[i].material) && scene.objects[i].material.shininess == scene.objects[object].material.shininess) return i;
    return object;
}

/// One table a distinct exponent.
template <PrecisionTier Tier, Q16 Exponent>
SHADE16_TABLE_OF_TEMPLATE Shininess<Tier> shininess_table = shininess<Tier>(Exponent);

template <const Scene& scene, PrecisionTier Tier>
struct ShininessOfScene {
    const Shininess<Tier>* table[at_least_one(scene.objects.count)]{};

    constexpr ShininessOfScene() { fill<0>(); }

private:
    template <uint32_t I>
    constexpr void fill() {
        if constexpr (I < scene.objects.count) {
            if constexpr (has_specular(scene, scene.objects[I].material)) table[I] = &shininess_table<Tier, scene.objects[I].material.shininess>;
            fill<I + 1>();
        }
    }
};
}  // namespace detail

/// Draws a constexpr scene. `Have` may ask for more terms than the scene uses, so that several scenes share one pipeline
/// or a Frame has room to vary; it can not have fewer. `Colors` is channels_of_format of what it draws to.
template <const Scene& scene, PrecisionTier Tier = mediump, VertexStore Store = VertexStore::keep, Needs Have = needs_of(scene),
          Channels Colors = Channels::rgb>
class Renderer {
    static_assert(covers(Have, needs_of(scene)), "this Renderer was built for fewer terms than the scene uses");

public:
    template <uint32_t Slots>
    constexpr explicit Renderer(Workspace<scene, Tier, Store, Slots, Colors>& memory) : pipeline_({scene, shininess_.table}, memory.view()) {}

    static constexpr Needs needs = Have;

    /// Exponents that vary at run time: kernels in the caller's memory, one an object, made by shininess<Tier>(exponent) and used from the
    /// next frame on. To be called again whenever one of them has changed. In highp that costs nothing; in the 16-bit tiers it makes a table anew.
    constexpr void use_shininess(const Shininess<Tier>* const* kernels) { pipeline_.use_shininess(kernels); }

    constexpr void begin(const Frame& frame, Viewport viewport) { pipeline_.begin(frame, viewport); }
    template <PixelFormat Format>
    constexpr void draw(const Band<Format>& band) {
        pipeline_.draw(band);
    }
    constexpr auto lit_vertex(uint32_t object, uint32_t index) { return pipeline_.lit_vertex(object, index); }

private:
    static constexpr detail::ShininessOfScene<scene, Tier> shininess_{};
    Pipeline<Have, Tier, Store, Colors> pipeline_;
};

/// Draws a frame band by band, from top to bottom, and hands each to the sink. `buffers` are one or two BandBuffers: with
/// two the engine draws one while the sink sends the other.
template <class AnyRenderer, class Buffer, size_t Count, class S>
constexpr void present(AnyRenderer& renderer, const Frame& frame, Viewport viewport, Buffer (&buffers)[Count], S& sink) {
    static_assert(Count == 1 || Count == 2, "a frame is drawn into one band buffer, or into two in turn");
    static_assert(Sink<S, typename Buffer::Format>, "the sink lacks flush(area, pixels, bytes, last) or wait()");
    renderer.begin(frame, viewport);
    size_t turn = 0;
    for (int32_t y = 0; y < viewport.height; y += Buffer::rows, turn = Count - 1 - turn) {
        const auto band = buffers[turn].band(y, min(Buffer::rows, viewport.height - y));
        if (Count == 1) sink.wait();  // the one buffer is still being sent
        renderer.draw(band);
        if (Count == 2) sink.wait();  // the other one must be gone before this one follows
        sink.flush({0, y, band.width, band.rows}, band.pixels, band.pixel_bytes(), y + band.rows >= viewport.height);
    }
    sink.wait();
}

}  // namespace shade16
