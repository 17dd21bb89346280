// What a scene and a frame must be before the engine sees them. Each function answers the first thing that is wrong.
#pragma once

#include "shade16.h"

namespace shade16::c {

shade16_status check(const shade16_camera& camera);
shade16_status check(const shade16_light& light);
shade16_status check(const shade16_material& material);
shade16_status check(const shade16_pose& pose);
shade16_status check(const shade16_mesh& mesh);
shade16_status check(const shade16_scene& scene);
/// A frame of so many lights and objects.
shade16_status check(const shade16_frame& frame, uint32_t lights, uint32_t objects);

inline bool is_misaligned(const void* array) { return reinterpret_cast<uintptr_t>(array) % alignof(uint16_t) != 0; }

/// check() of every element.
template <class T>
shade16_status check_all(const T* first, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i)
        if (const shade16_status status = check(first[i]); status != SHADE16_OK) return status;
    return SHADE16_OK;
}

}  // namespace shade16::c
