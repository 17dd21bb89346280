// Scene: what to draw. Plain constexpr aggregates; what changes from frame to frame goes in a Frame.
#pragma once

#include "shade16/scene/camera.hpp"
#include "shade16/scene/light.hpp"
#include "shade16/scene/material.hpp"
#include "shade16/scene/mesh.hpp"

namespace shade16 {

/// v -> rotation * (scale * v) + translation. A scale differs by axis only if it must: normals are then renormalised.
struct Pose {
    Mat3 rotation{};
    Vec3 scale{1, 1, 1};  // above 0
    Vec3 translation{};
    friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// A pose that turns a mesh about its own centre and puts that centre at the origin.
constexpr Pose centred_pose(const Mesh& mesh, const Mat3& rotation, Q16 scale = 1) {
    return {rotation, {scale, scale, scale}, -(rotation * (mesh.centre * scale))};
}

struct Object {
    Mesh mesh;
    Material material{};
    Pose pose{};
};

struct Scene {
    Camera camera{};
    View<Light> lights{};
    View<Object> objects{};
    Rgb background = black;
};

/// Which part of the light a frame shows. Where nothing saturates the three parts add up to `all`, bit for bit in the accumulator (with
/// vertex colours, within one unit of it). ambient: ambient and emissive light, and all of an unlit object.
enum class Component : uint8_t { all, ambient, diffuse, specular };

constexpr bool shows(Component shown, Component part) { return shown == Component::all || shown == part; }

/// The values of one frame, where they differ from the scene's. They may vary a term, never add one: a scene compiled
/// without specular has no code for it, and one seen in perspective stays so. An array, when given, has as many elements
/// as the scene's.
struct Frame {
    const Camera* camera = nullptr;
    const Light* lights = nullptr;
    const Pose* poses = nullptr;
    const Material* materials = nullptr;  // vary in colours and reflection alone; an exponent varies by Renderer::use_shininess
    Component component = Component::all;
};

}  // namespace shade16
