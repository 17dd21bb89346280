// A core scene as the textbook's shaders take it: plain doubles, GLM's own matrices, lights in eye coordinates.
#pragma once

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "host_sim/textbook/shaders.hpp"
#include "shade16/scene/scene.hpp"

namespace shade16::host {

class TextbookScene {
public:
    TextbookScene(const Scene& scene, Viewport viewport) : scene_(scene), viewport_(viewport) {
        const Camera& c = scene.camera;
        view_ = glm::lookAt(number(c.eye), number(c.target), number(c.up));
        const double aspect = static_cast<double>(viewport.width) / viewport.height;
        const double near = number(c.near_distance), far = number(c.far_distance);
        const double half = number(c.view_height) / 2;
        projection_ = c.projection == Projection::perspective ? glm::perspective(turns(c.fov_y) * 2 * 3.14159265358979323846, aspect, near, far)
                                                              : glm::ortho(-half * aspect, half * aspect, -half, half, near, far);
    }

    textbook::Uniforms uniforms(uint32_t o, textbook::Mode mode = textbook::Mode::all) const {
        const Object& object = scene_.objects[o];
        const Pose& pose = object.pose;
        const glm::dmat4 rotation = glm::dmat4(matrix(pose.rotation));
        const glm::dmat4 model = glm::translate(glm::dmat4(1), number(pose.translation)) * rotation * glm::scale(glm::dmat4(1), number(pose.scale));
        textbook::Uniforms u{.model_view = view_ * model, .projection = projection_, .material = material(object.material)};
        u.mode = mode;
        u.local_viewer = scene_.camera.viewer == Viewer::local && scene_.camera.projection == Projection::perspective;
        for (const Light& light : scene_.lights) {
            if (light.kind == LightKind::ambient) {
                u.ambient_light += number(light.intensity) * number(light.diffuse);
                continue;
            }
            const bool lamp = light.kind != LightKind::directional;
            const glm::dvec4 given(number(light.position), lamp ? 1 : 0);
            // A direction that rides on an object turns with it, and is not stretched with it.
            const glm::dmat4 to_eye = light.space == Space::view    ? glm::dmat4(1)
                                      : light.space == Space::world ? view_
                                                                    : view_ * (lamp ? model : rotation);
            const Attenuation& a = light.attenuation;
            const double intensity = number(light.intensity);
            u.lights.push_back({.position = to_eye * given,
                                .diffuse = intensity * number(light.diffuse),
                                .specular = intensity * number(light.specular),
                                .constant = number(a.constant),
                                .linear = number(a.linear),
                                .quadratic = number(a.quadratic)});
        }
        return u;
    }

    textbook::Attributes attributes(uint32_t o, uint32_t vertex) const {
        const Mesh& mesh = scene_.objects[o].mesh;
        const Position16 p = mesh.positions[vertex];
        const Normal14 n = mesh.normals[vertex];
        const glm::dvec3 place = number(mesh.centre) + glm::dvec3(p.x, p.y, p.z) / std::exp2(mesh.fraction_bits);
        textbook::Attributes a{place, glm::dvec3(n.x.raw, n.y.raw, n.z.raw)};
        if (mesh.colors.count != 0) a.color = number(mesh.colors[vertex]);
        return a;
    }

    /// Pixels from the top left.
    glm::dvec2 on_screen(const glm::dvec4& clip) const {
        return {(clip.x / clip.w + 1) / 2 * viewport_.width, (1 - clip.y / clip.w) / 2 * viewport_.height};
    }

private:
    static double number(Q16 v) { return v.raw / 65536.0; }
    static double number(Scaled s) { return s.mantissa * std::exp2(s.exponent - 32); }
    static double turns(Angle a) { return a.turns / 4294967296.0; }
    static glm::dvec3 number(Vec3 v) { return {number(v.x), number(v.y), number(v.z)}; }
    static glm::dvec3 number(Rgb c) { return glm::dvec3(c.r.raw, c.g.raw, c.b.raw) / 65535.0; }
    static glm::dmat3 matrix(const Mat3& m) {
        glm::dmat3 result;
        for (int i = 0; i < 3; ++i) {
            const Normal30& row = m.row[i];
            result[0][i] = row.x.raw / 0x1p30, result[1][i] = row.y.raw / 0x1p30, result[2][i] = row.z.raw / 0x1p30;
        }
        return result;
    }
    static textbook::Material material(const Material& m) {
        return {.ambient = number(m.ambient_color()),
                .diffuse = number(m.diffuse),
                .specular = number(m.specular),
                .emission = number(m.emissive),
                .shininess = number(m.shininess),
                .highlight = m.reflection == Reflection::phong ? textbook::Highlight::phong : textbook::Highlight::blinn_phong};
    }

    const Scene& scene_;
    Viewport viewport_;
    glm::dmat4 view_{1}, projection_{1};
};

}  // namespace shade16::host
