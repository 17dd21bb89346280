// The renderer behind shade16.h: a scene in the caller's memory, and the pipeline that draws it.
#pragma once

#include "layout.hpp"

struct shade16_renderer {
    shade16::c::Arrays arrays;
    shade16::Scene scene{};
    shade16::Viewport viewport{};
    bool is_begun = false;
    shade16::c::LibraryPipeline pipeline;

    explicit shade16_renderer(const shade16::c::Arrays& a) : arrays(a), pipeline({scene, a.kernel_of_object}, a.work) {}
};

namespace shade16::c {

/// Memory as SHADE16_WORKSPACE_BYTES counts it is never less than what lay_out takes: each part, and the gaps before it.
constexpr size_t gaps = 9 * (SHADE16_ALIGNMENT - 1);
static_assert(sizeof(shade16_renderer) + gaps <= SHADE16_RENDERER_BYTES, "SHADE16_RENDERER_BYTES is too small");
static_assert(sizeof(Object) + sizeof(void*) + sizeof(KeptKernel) + sizeof(ObjectState<Tier>) <= SHADE16_OBJECT_BYTES, "SHADE16_OBJECT_BYTES is too small");
static_assert(sizeof(Light) <= SHADE16_LIGHT_BYTES, "SHADE16_LIGHT_BYTES is too small");
static_assert(sizeof(ObjectLight<Tier>) + sizeof(LampShape) <= SHADE16_OBJECT_LIGHT_BYTES, "SHADE16_OBJECT_LIGHT_BYTES is too small");
static_assert(sizeof(ScreenVertex<Tier>) <= SHADE16_VERTEX_BYTES, "SHADE16_VERTEX_BYTES is too small: it depends on the tier");
static_assert(sizeof(FaceColor<Tier>) <= SHADE16_FACE_BYTES, "SHADE16_FACE_BYTES is too small: it depends on the tier");

}  // namespace shade16::c
