#include "check.hpp"

namespace shade16::c {

shade16_status check(const shade16_camera& c) {
    if (c.projection > SHADE16_ORTHOGRAPHIC || c.viewer > SHADE16_VIEWER_LOCAL) return SHADE16_UNKNOWN_VALUE;
    if (c.near_distance <= 0 || c.far_distance <= c.near_distance) return SHADE16_NEAR_AND_FAR;
    if (c.projection == SHADE16_ORTHOGRAPHIC) return c.view_height <= 0 ? SHADE16_VIEW_HEIGHT : SHADE16_OK;
    return c.fov_y == 0 || c.fov_y >= SHADE16_DEGREES(180) ? SHADE16_FIELD_OF_VIEW : SHADE16_OK;
}

shade16_status check(const shade16_light& light) {
    return light.kind > SHADE16_LIGHT_SPOT || light.space > SHADE16_SPACE_OBJECT ? SHADE16_UNKNOWN_VALUE : SHADE16_OK;
}

shade16_status check(const shade16_material& m) {
    const bool is_known = m.reflection <= SHADE16_REFLECTION_PHONG && m.shading <= SHADE16_SHADING_PHONG && m.normal_path <= SHADE16_NORMALS_SPHERICAL;
    return is_known ? SHADE16_OK : SHADE16_UNKNOWN_VALUE;
}

shade16_status check(const shade16_pose& pose) {
    return pose.scale.x > 0 && pose.scale.y > 0 && pose.scale.z > 0 ? SHADE16_OK : SHADE16_SCALE_NOT_POSITIVE;
}

static shade16_status check_arrays(const shade16_mesh& m) {
    if (m.vertex_count > SHADE16_MAX_VERTICES) return SHADE16_TOO_MANY_VERTICES;
    if (m.triangle_count > SHADE16_MAX_TRIANGLES) return SHADE16_TOO_MANY_TRIANGLES;
    if ((m.positions == nullptr && m.vertex_count != 0) || (m.triangles == nullptr && m.triangle_count != 0)) return SHADE16_NULL_ARRAY;
    if (is_misaligned(m.positions) || is_misaligned(m.normals) || is_misaligned(m.colors) || is_misaligned(m.triangles)) return SHADE16_ARRAY_MISALIGNED;
    return SHADE16_OK;
}

shade16_status check(const shade16_mesh& m) {
    if (const shade16_status status = check_arrays(m); status != SHADE16_OK) return status;
    if (m.fraction_bits < 0 || m.fraction_bits > 30) return SHADE16_FRACTION_BITS_OUT_OF_RANGE;
    for (uint32_t i = 0; i < m.triangle_count; ++i) {
        const shade16_triangle& t = m.triangles[i];
        if (t.a >= m.vertex_count || t.b >= m.vertex_count || t.c >= m.vertex_count) return SHADE16_INDEX_OUT_OF_RANGE;
    }
    return SHADE16_OK;
}

static shade16_status check(const shade16_object& object) {
    if (object.mesh == nullptr) return SHADE16_NULL_MESH;
    shade16_status status = check(*object.mesh);
    if (status == SHADE16_OK) status = check(object.material);
    if (status == SHADE16_OK) status = check(object.pose);
    return status;
}

shade16_status check(const shade16_scene& scene) {
    if (scene.light_count > SHADE16_MAX_LIGHTS) return SHADE16_TOO_MANY_LIGHTS;
    if (scene.object_count > SHADE16_MAX_OBJECTS) return SHADE16_TOO_MANY_OBJECTS;
    if ((scene.lights == nullptr && scene.light_count != 0) || (scene.objects == nullptr && scene.object_count != 0)) return SHADE16_NULL_ARRAY;
    if (scene.width_px < 1 || scene.width_px > 2048 || scene.height_px < 1 || scene.height_px > 2048) return SHADE16_SCREEN_SIZE;
    shade16_status status = check(scene.camera);
    if (status == SHADE16_OK) status = check_all(scene.lights, scene.light_count);
    for (uint32_t i = 0; i < scene.object_count && status == SHADE16_OK; ++i) status = check(scene.objects[i]);
    return status;
}

shade16_status check(const shade16_frame& f, uint32_t lights, uint32_t objects) {
    if (f.component > SHADE16_COMPONENT_SPECULAR) return SHADE16_UNKNOWN_VALUE;
    if (f.lights != nullptr && f.light_count != lights) return SHADE16_COUNT_DIFFERS;
    if (f.poses != nullptr && f.pose_count != objects) return SHADE16_COUNT_DIFFERS;
    if (f.materials != nullptr && f.material_count != objects) return SHADE16_COUNT_DIFFERS;
    shade16_status status = SHADE16_OK;
    if (f.camera != nullptr) status = check(*f.camera);
    if (f.lights != nullptr && status == SHADE16_OK) status = check_all(f.lights, lights);
    if (f.poses != nullptr && status == SHADE16_OK) status = check_all(f.poses, objects);
    if (f.materials != nullptr && status == SHADE16_OK) status = check_all(f.materials, objects);
    return status;
}

}  // namespace shade16::c
