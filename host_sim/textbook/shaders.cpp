#include "host_sim/textbook/shaders.hpp"

#include <cmath>

#include <glm/gtc/matrix_inverse.hpp>

namespace shade16::textbook {

namespace {
bool shows(Mode mode, Mode term) { return mode == Mode::all || mode == term; }

glm::dvec3 normalized(const glm::dvec3& v) { return v == glm::dvec3(0) ? v : glm::normalize(v); }

double highlight(const Material& material, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    const double cosine = material.highlight == Highlight::phong ? glm::dot(glm::reflect(-l, n), v) : glm::dot(n, normalized(l + v));
    return std::pow(glm::max(cosine, 0.0), material.shininess);
}

/// The light that leaves a point towards the viewer, saturated as a framebuffer does.
glm::dvec3 shade(const Uniforms& u, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& factor) {
    const glm::dvec3 n = normalized(normal);
    const glm::dvec3 v = u.local_viewer ? normalized(-position) : glm::dvec3(0, 0, 1);

    glm::dvec3 color(0);
    if (shows(u.mode, Mode::ambient_only)) color += factor * (u.material.emission + u.material.ambient * u.ambient_light);
    for (const Light& light : u.lights) {
        const glm::dvec3 to_light = glm::dvec3(light.position) - light.position.w * position;
        const glm::dvec3 l = normalized(to_light);
        const double n_dot_l = glm::dot(n, l);
        if (n_dot_l <= 0) continue;  // the light is behind the surface: neither term
        const double d = glm::length(to_light);
        const double attenuation = light.position.w == 0 ? 1 : 1 / (light.constant + light.linear * d + light.quadratic * d * d);
        if (shows(u.mode, Mode::diffuse_only)) color += attenuation * factor * u.material.diffuse * light.diffuse * n_dot_l;
        if (shows(u.mode, Mode::specular_only))
            color += attenuation * u.material.specular * light.specular * highlight(u.material, n, l, v);
    }
    return glm::clamp(color, 0.0, 1.0);
}

Varyings transform(const Uniforms& u, const Attributes& vertex) {
    const glm::dvec4 eye = u.model_view * glm::dvec4(vertex.position, 1);
    const glm::dmat3 normal_matrix = glm::inverseTranspose(glm::dmat3(u.model_view));
    return {u.projection * eye, glm::dvec3(eye), normalized(normal_matrix * vertex.normal), vertex.color};
}
}  // namespace

namespace per_vertex {
Varyings vertex_shader(const Uniforms& uniforms, const Attributes& vertex) {
    Varyings out = transform(uniforms, vertex);
    out.color = shade(uniforms, out.eye_position, out.eye_normal, vertex.color);
    return out;
}
glm::dvec3 fragment_shader(const Varyings& interpolated) { return interpolated.color; }
}  // namespace per_vertex

namespace per_fragment {
Varyings vertex_shader(const Uniforms& uniforms, const Attributes& vertex) { return transform(uniforms, vertex); }
glm::dvec3 fragment_shader(const Uniforms& uniforms, const Varyings& in) {
    return shade(uniforms, in.eye_position, in.eye_normal, in.color);
}
}  // namespace per_fragment

Varyings interpolate(const Varyings& u, const Varyings& v, const Varyings& w, const glm::dvec3& k) {
    const auto mixed = [&k](const auto& a, const auto& b, const auto& c) { return k.x * a + k.y * b + k.z * c; };
    return {mixed(u.clip_position, v.clip_position, w.clip_position), mixed(u.eye_position, v.eye_position, w.eye_position),
            mixed(u.eye_normal, v.eye_normal, w.eye_normal), mixed(u.color, v.color, w.color)};
}

}  // namespace shade16::textbook
