#include "host_sim/reference/scene.hpp"

namespace shade16::reference {

Mesh value(const shade16::Mesh& mesh) {
    Mesh result;
    const glm::dvec3 centre = value(mesh.centre);
    for (const Position16& p : mesh.positions)
        result.positions.push_back(centre + glm::dvec3(p.x, p.y, p.z) * std::ldexp(1.0, -mesh.fraction_bits));
    for (const Normal14& n : mesh.normals) result.normals.push_back(value(n));
    for (const Rgb& c : mesh.colors) result.colors.push_back(value(c));
    for (const TexCoord16& at : mesh.texcoords) result.texcoords.push_back(glm::dvec2(at.s, at.t) * std::ldexp(1.0, -mesh.texcoord_bits));
    for (const shade16::Triangle& t : mesh.triangles) result.triangles.push_back({t.a, t.b, t.c});
    return result;
}

Scene value(const shade16::Scene& scene) {
    Scene result{scene, {}};
    for (const Object& object : scene.objects) result.meshes.push_back(value(object.mesh));
    return result;
}

}  // namespace shade16::reference
