#include "host_sim/bounds/float32.hpp"

namespace shade16::bounds {
namespace {

glm::vec3 normalized(const glm::vec3& v) { return v == glm::vec3(0) ? v : glm::normalize(v); }

/// Blinn-Phong in the world, of one object and lamps that neither fade nor end.
class FloatVertexLight {
public:
    explicit FloatVertexLight(const reference::Scene& exact)
        : scene_(exact),
          object_(exact.values.objects[0]),
          rotation_(reference::value(object_.pose.rotation)),
          scale_(reference::value(object_.pose.scale)),
          view_to_world_(glm::transpose(reference::make_view(exact.values.camera, {1, 1}).rotation)),
          eye_(reference::value(exact.values.camera.eye)) {}

    glm::vec3 operator()(uint32_t vertex) const {
        const glm::vec3 position = rotation_ * (scale_ * glm::vec3(scene_.meshes[0].positions[vertex])) +
                                   glm::vec3(reference::value(object_.pose.translation));
        const glm::vec3 n = normalized(rotation_ * (glm::vec3(scene_.meshes[0].normals[vertex]) / scale_));
        const glm::vec3 v = scene_.values.camera.sees_locally() ? normalized(eye_ - position) : view_to_world_[2];
        const Material& m = object_.material;
        glm::vec3 color(0);
        for (const Light& light : scene_.values.lights) {
            const glm::vec3 l = normalized(towards(light, position));
            const float n_dot_l = glm::dot(n, l);
            if (n_dot_l <= 0) continue;
            const float cosine = std::fmax(glm::dot(n, normalized(l + v)), 0.0f);
            color += glm::vec3(reference::value(m.diffuse)) * n_dot_l +
                     glm::vec3(reference::value(m.specular)) *
                         std::pow(cosine, static_cast<float>(reference::value(m.shininess)));
        }
        return glm::clamp(color, 0.0f, 1.0f);
    }

private:
    glm::vec3 towards(const Light& light, const glm::vec3& position) const {
        glm::vec3 given = reference::value(light.position);
        if (light.space == Space::view) given = view_to_world_ * given + (light.is_lamp() ? eye_ : glm::vec3(0));
        if (light.space == Space::object)
            given = light.is_lamp() ? glm::vec3(reference::to_world(object_.pose, reference::value(light.position)))
                                    : rotation_ * given;
        return light.is_lamp() ? given - position : given;
    }

    const reference::Scene& scene_;
    const Object& object_;
    glm::mat3 rotation_;
    glm::vec3 scale_;
    glm::mat3 view_to_world_;
    glm::vec3 eye_;
};

}  // namespace

VertexFigures search_float32(const VertexDomain& domain) {
    host::Random random(domain.seed);
    VertexFigures figures;
    for (int restart = 0; restart < domain.restarts; ++restart) {
        const host::RandomSurface surface(random, domain.options);
        const reference::Scene exact = reference::value(surface.scene());
        const FloatVertexLight lit(exact);
        for (uint32_t i = 0; i < host::RandomSurface::vertex_count; ++i) {
            const glm::dvec3 color = lit(i);
            figures.add(host::judge(color, reference::light_vertex(exact, {}, 0, i), exact.values.objects[0].material,
                                    host::promised<highp>(24)),
                        color);
        }
    }
    return figures;
}

}  // namespace shade16::bounds
