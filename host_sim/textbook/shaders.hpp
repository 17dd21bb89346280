// The two shaders that every introduction to lighting writes, in double precision and in eye space: light at each vertex
// (Gouraud) or at each fragment (Phong). A second reference: it shares nothing with reference/ or the core, neither code
// nor a file, so that both would have to err alike.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace shade16::textbook {

/// Which terms are shown: the number keys of the usual demonstration.
enum class Mode { all = 1, ambient_only = 2, diffuse_only = 3, specular_only = 4 };

/// The highlight: (R.V)^n with the mirrored light, or (N.H)^n with the half vector.
enum class Highlight { phong, blinn_phong };

struct Light {
    glm::dvec4 position{0, 0, 1, 0};  // in eye coordinates; w = 0 is a direction towards a light far away
    glm::dvec3 diffuse{1}, specular{1};
    double constant = 1, linear = 0, quadratic = 0;  // of the attenuation, where w = 1
};

struct Material {
    glm::dvec3 ambient{0}, diffuse{1}, specular{0}, emission{0};
    double shininess = 32;
    Highlight highlight = Highlight::blinn_phong;
};

struct Uniforms {
    glm::dmat4 model_view{1}, projection{1};
    glm::dvec3 ambient_light{0};
    std::vector<Light> lights{};
    Material material{};
    bool local_viewer = false;  // else the viewer is infinitely far along +z
    Mode mode = Mode::all;
};

struct Attributes {
    glm::dvec3 position{}, normal{};
    glm::dvec3 color{1};  // a factor on the ambient and diffuse colours
};

/// What a vertex hands on, to be interpolated.
struct Varyings {
    glm::dvec4 clip_position{};           // gl_Position
    glm::dvec3 eye_position{}, eye_normal{};  // with per-fragment light
    glm::dvec3 color{1};                  // the factor, or with per-vertex light the colour
};

namespace per_vertex {
Varyings vertex_shader(const Uniforms& uniforms, const Attributes& vertex);
glm::dvec3 fragment_shader(const Varyings& interpolated);
}  // namespace per_vertex

namespace per_fragment {
Varyings vertex_shader(const Uniforms& uniforms, const Attributes& vertex);
glm::dvec3 fragment_shader(const Uniforms& uniforms, const Varyings& interpolated);
}  // namespace per_fragment

/// a u + b v + c w: what arrives at a fragment (noperspective, as the engine interpolates over the screen).
Varyings interpolate(const Varyings& u, const Varyings& v, const Varyings& w, const glm::dvec3& weights);

}  // namespace shade16::textbook
