// The same pipeline in double precision: transform, clip, light, raster. It is never linked by core or firmware.
#pragma once

#include <array>

#include "host_sim/reference/light.hpp"
#include "host_sim/reference/raster.hpp"
#include "host_sim/reference/scene.hpp"

namespace shade16::reference {

/// The values of one frame, resolved against the scene's.
struct FrameValues {
    const Camera& camera;
    shade16::View<Light> lights;
    const Pose* poses;  // nullptr: the objects' own
    const Material* materials;  // nullptr: the objects' own
    Component component;

    FrameValues(const shade16::Scene& scene, const Frame& frame)
        : camera(frame.camera != nullptr ? *frame.camera : scene.camera),
          lights(frame.lights != nullptr ? frame.lights : scene.lights.first, scene.lights.count), poses(frame.poses),
          materials(frame.materials), component(frame.component) {}
    const Pose& pose(const shade16::Scene& scene, std::size_t object) const {
        return poses != nullptr ? poses[object] : scene.objects[static_cast<uint32_t>(object)].pose;
    }
    /// With the colours of the frame, those black that its component does not show.
    Material material(const shade16::Scene& scene, std::size_t object) const {
        Material m = scene.objects[static_cast<uint32_t>(object)].material;
        if (materials != nullptr) {
            const Material& of_frame = materials[object];
            m.ambient = of_frame.ambient, m.diffuse = of_frame.diffuse, m.specular = of_frame.specular, m.emissive = of_frame.emissive;
            m.reflection = of_frame.reflection;
        }
        m.ambient = shows(component, Component::ambient) ? m.ambient_color() : black;
        if (!shows(component, Component::ambient)) m.emissive = black;
        if (!shows(component, m.unlit ? Component::ambient : Component::diffuse)) m.diffuse = black;
        if (!shows(component, Component::specular)) m.specular = black;
        return m;
    }
};

/// The light at a vertex, and at a face's centre with the face's own normal, in parts.
LightParts light_vertex(const Scene& scene, const Frame& frame, std::size_t object, uint32_t vertex);
LightParts light_face(const Scene& scene, const Frame& frame, std::size_t object, uint32_t face);

/// A point inside a face on the screen.
struct FacePoint {
    glm::dvec3 weights{};                  // barycentric
    std::array<glm::dvec2, 3> corner_px{};  // what spherical interpolation follows: edges first, then rows of pixels
    glm::dvec3 weights_in_space{};          // barycentric before projection: what texture coordinates in perspective follow
    bool on_table_map = false;              // normals are interpolated on the light table's map
    glm::dvec2 texel_shift{};              // where to look textures up instead, in texels: for errors of coordinates
};

/// Whether a face's pixels differ by more than colours interpolated from its corners.
bool is_by_pixel(const Object& object);

/// The light at a point of a face. With Phong shading its normal is interpolated and renormalised; otherwise the light of its
/// corners, or of its centre, is interpolated. Textures count.
LightParts light_surface(const Scene& scene, const Frame& frame, std::size_t object, uint32_t face, const FacePoint& at, Channels channels = Channels::rgb);

/// Draws the whole scene; for a grey target its luma, in all three channels.
Picture draw(const Scene& scene, const Frame& frame, Viewport viewport, Channels channels = Channels::rgb);

}  // namespace shade16::reference
