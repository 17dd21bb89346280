// ByteMesh: a mesh and its arrays from bytes. Built-in shapes, or points and triangles with nothing in common; sometimes with
// positions at the ends of 16 bits, normals of any length, and corners that coincide. Indices and numbers of elements are
// always those of a mesh: nobody checks them a pixel.
#pragma once

#include <vector>

#include "tests/fuzz/byte_fields.hpp"

namespace shade16::fuzz {

class ByteMesh {
public:
    explicit ByteMesh(ByteFields& f) {
        const uint32_t kind = f.below(8);
        if (kind < 5) {
            const bool has_texcoords = f.one_in(2);
            copy(shape(kind, has_texcoords));
            disturb(f);
        } else {
            scatter(f);
        }
        if (f.one_in(4))
            for (std::size_t i = 0; i < positions_.size(); ++i) colors_.push_back(f.color());
        mesh_.positions = view(positions_), mesh_.normals = view(normals_), mesh_.colors = view(colors_);
        mesh_.texcoords = view(texcoords_), mesh_.triangles = view(triangles_);
        mesh_.centre = f.is_extreme() ? f.vec3(-16384'000, 16383'000) : Vec3{};
        if (f.is_extreme()) mesh_.fraction_bits = f.i8();
        if (f.is_extreme()) mesh_.texcoord_bits = f.i8();
        mesh_.convex = f.one_in(2);
    }
    ByteMesh(const ByteMesh&) = delete;
    ByteMesh& operator=(const ByteMesh&) = delete;

    const Mesh& mesh() const { return mesh_; }

private:
    template <class T>
    static View<T> view(const std::vector<T>& v) {
        return {v.data(), static_cast<uint32_t>(v.size())};
    }

    static Mesh shape(uint32_t kind, bool has_texcoords) {
        switch (kind) {
            case 0: return has_texcoords ? textured_cube.mesh() : cube.mesh();
            case 1: return has_texcoords ? textured_quad.mesh() : quad.mesh();
            case 2: return has_texcoords ? textured_torus<8, 5>.mesh() : torus<8, 5>.mesh();
            default: return has_texcoords ? textured_sphere<7, 5>.mesh() : sphere<7, 5>.mesh();
        }
    }
    void copy(const Mesh& from) {
        positions_.assign(from.positions.begin(), from.positions.end()), normals_.assign(from.normals.begin(), from.normals.end());
        texcoords_.assign(from.texcoords.begin(), from.texcoords.end()), triangles_.assign(from.triangles.begin(), from.triangles.end());
        mesh_.fraction_bits = from.fraction_bits, mesh_.texcoord_bits = from.texcoord_bits;
    }

    /// A few vertices elsewhere.
    void disturb(ByteFields& f) {
        for (uint32_t count = f.is_extreme() ? f.below(9) : 0; count > 0; --count) {
            const std::size_t i = f.below(static_cast<uint32_t>(positions_.size()));
            positions_[i] = position(f), normals_[i] = normal(f);
        }
    }
    void scatter(ByteFields& f) {
        const uint32_t vertices = 3 + f.below(14), triangles = f.below(12);
        const bool has_texcoords = f.one_in(2);
        for (uint32_t i = 0; i < vertices; ++i) {
            positions_.push_back(position(f)), normals_.push_back(normal(f));
            if (has_texcoords) texcoords_.push_back({f.i16(), f.i16()});
        }
        const auto corner = [&] { return static_cast<uint16_t>(f.below(vertices)); };
        for (uint32_t i = 0; i < triangles; ++i) {
            const uint16_t a = corner(), b = corner(), c = corner();
            triangles_.push_back({a, b, c}), triangles_.push_back({a, c, b});  // one of the two faces the camera
        }
    }

    static int16_t coordinate(ByteFields& f) {
        constexpr int16_t ends[] = {INT16_MIN, INT16_MAX, 0, 1};
        return f.is_extreme() ? ends[f.below(4)] : f.i16();
    }
    static Position16 position(ByteFields& f) {
        const int16_t x = coordinate(f), y = coordinate(f), z = coordinate(f);
        return {x, y, z};
    }
    static Normal14 normal(ByteFields& f) {
        const int16_t x = coordinate(f), y = coordinate(f), z = coordinate(f);
        if (f.is_extreme()) return {{x}, {y}, {z}};
        const Normal30 unit = normalize30({x, y, z});
        return {Unit14::from_raw(unit.x.raw >> 16), Unit14::from_raw(unit.y.raw >> 16), Unit14::from_raw(unit.z.raw >> 16)};
    }

    std::vector<Position16> positions_{};
    std::vector<Normal14> normals_{};
    std::vector<Rgb> colors_{};
    std::vector<TexCoord16> texcoords_{};
    std::vector<Triangle> triangles_{};
    Mesh mesh_{};
};

}  // namespace shade16::fuzz
