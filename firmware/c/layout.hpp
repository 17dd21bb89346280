// Where everything lies in the memory that the caller gives: counted first, then made there.
#pragma once

#include "config.hpp"
#include "shade16.h"

namespace shade16::c {

/// Says that an object is to be made where memory is already: <new> is no part of every freestanding compiler.
struct Here {
    void* at;
};

/// How many of everything a scene has.
struct Counts {
    uint32_t objects = 0, lights = 0;
    uint64_t vertices = 0, flat_faces = 0;
};

/// Hands out arrays one behind the other. Without memory it counts only.
class Arena {
public:
    explicit Arena(void* memory) : memory_(static_cast<unsigned char*>(memory)) {}
    uint64_t bytes() const { return bytes_; }

    /// `count` of them, made as T{} makes them; nullptr for none.
    template <class T>
    T* array(uint64_t count);
    /// Room for so many, in which nothing is made yet.
    template <class T>
    unsigned char* reserve(uint64_t count = 1);

private:
    unsigned char* memory_;
    uint64_t bytes_ = 0;
};

}  // namespace shade16::c

inline void* operator new(size_t, shade16::c::Here here) noexcept { return here.at; }
inline void operator delete(void*, shade16::c::Here) noexcept {}

namespace shade16::c {

template <class T>
unsigned char* Arena::reserve(uint64_t count) {
    static_assert(alignof(T) <= SHADE16_ALIGNMENT);
    bytes_ = (bytes_ + alignof(T) - 1) & ~uint64_t{alignof(T) - 1};
    const uint64_t first = bytes_;
    bytes_ += count * sizeof(T);
    return memory_ == nullptr || count == 0 ? nullptr : memory_ + static_cast<size_t>(first);
}

template <class T>
T* Arena::array(uint64_t count) {
    unsigned char* const at = reserve<T>(count);
    if (at == nullptr) return nullptr;
    for (uint64_t i = 0; i < count; ++i) new (Here{at + static_cast<size_t>(i) * sizeof(T)}) T{};
    return reinterpret_cast<T*>(at);
}

/// A shininess kernel and the exponent that it was made for; 0 before it is made.
struct KeptKernel {
    Kernel kernel{};
    int32_t exponent = 0;
};

/// The arrays of a renderer, and the pipeline's view of some of them.
struct Arrays {
    Object* objects;
    Light* lights;
    const Kernel** kernel_of_object;
    KeptKernel* kernels;
    WorkspaceView<Tier> work;
};

inline Arrays lay_out(Arena& arena, const Counts& n) {
    const uint64_t pairs = uint64_t{n.objects} * n.lights;
    Arrays a{};
    a.objects = arena.array<Object>(n.objects);
    a.lights = arena.array<Light>(n.lights);
    a.kernel_of_object = arena.array<const Kernel*>(n.objects);
    a.kernels = arena.array<KeptKernel>(chosen_terms.specular ? n.objects : 0);
    a.work.objects = arena.array<ObjectState<Tier>>(n.objects);
    a.work.lights = arena.array<ObjectLight<Tier>>(pairs);
    if constexpr (shade16::detail::shapes_lamps(chosen_terms)) a.work.shapes = arena.array<LampShape>(pairs);
    a.work.vertices = arena.array<ScreenVertex<Tier>>(n.vertices);
    a.work.faces = arena.array<FaceColor<Tier>>(n.flat_faces);
    return a;
}

}  // namespace shade16::c
