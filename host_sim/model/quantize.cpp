#include "host_sim/model/quantize.hpp"

#include <map>

#include "host_sim/error.hpp"
#include "host_sim/model/convexity.hpp"
#include "host_sim/model/lattice.hpp"
#include "host_sim/model/unit_normal.hpp"
#include "host_sim/model/vertex_order.hpp"

namespace shade16::host {

namespace {

struct Vertex {
    Position16 position;
    Normal14 normal;
    Rgb color;
    TexCoord16 at;

    using Key = std::array<int32_t, 11>;
    Key key() const {
        return {position.x,  position.y,  position.z,  normal.x.raw, normal.y.raw, normal.z.raw,
                color.r.raw, color.g.raw, color.b.raw, at.s,         at.t};
    }
};

constexpr int largest_texcoord = 32767;

/// Twice the area, exactly: the products of two 17-bit differences.
bool has_area(Position16 a, Position16 b, Position16 c) {
    const auto turn = [&](int16_t Position16::*u, int16_t Position16::*v) {
        return (int64_t{b.*u} - a.*u) * (int64_t{c.*v} - a.*v) - (int64_t{b.*v} - a.*v) * (int64_t{c.*u} - a.*u);
    };
    return turn(&Position16::x, &Position16::y) != 0 || turn(&Position16::y, &Position16::z) != 0 ||
           turn(&Position16::z, &Position16::x) != 0;
}

Rgb rounded_color(const Double3& color) {
    const auto channel = [](double value) {
        return Unorm16::from_raw(static_cast<uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * Unorm16::one)));
    };
    return {channel(color[0]), channel(color[1]), channel(color[2])};
}

class Baker {
public:
    Baker(const Model& model, BakedModel& baked)
        : model_(model), baked_(baked), lattice_(lattice_for(model.positions)) {
        baked.centre = lattice_.centre;
        baked.fraction_bits = static_cast<int8_t>(lattice_.fraction_bits);
    }

    void bake(const ModelPart& part) {
        vertices_.clear();
        numbers_.clear();
        choose_texcoord_bits(part);
        std::vector<std::array<uint32_t, 3>> triangles;
        for (const auto& corners : part.triangles) {
            const auto at = [&](std::size_t i) { return lattice_.nearest(model_.positions[corners[i]]); };
            if (has_area(at(0), at(1), at(2))) {
                triangles.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
            } else {
                ++baked_.degenerate_triangles;
            }
        }
        if (!triangles.empty()) add_part(part, ordered_for_cache(triangles, vertices_.size(), vertex_cache_entries));
    }

private:
    /// Vertices that became equal by rounding are one from here on.
    uint32_t number_of(uint32_t index) {
        const Vertex vertex{lattice_.nearest(model_.positions[index]), nearest_normal(model_.normals[index]),
                            model_.colors.empty() ? white : rounded_color(model_.colors[index]), place_at(index)};
        note_errors(index, vertex);
        const auto [entry, is_new] = numbers_.try_emplace(vertex.key(), static_cast<uint32_t>(vertices_.size()));
        if (is_new) vertices_.push_back(vertex);
        return entry->second;
    }

    void choose_texcoord_bits(const ModelPart& part) {
        const bool is_textured = part.material.texture != nullptr || part.material.bump != nullptr;
        has_texcoords_ = !model_.texcoords.empty() && (is_textured || model_.texcoords_for_all_parts);
        texcoord_bits_ = 15;
        if (!has_texcoords_) return;
        double largest = 0;
        for (const auto& corners : part.triangles)
            for (const uint32_t i : corners) largest = std::max({largest, std::fabs(model_.texcoords[i][0]), std::fabs(model_.texcoords[i][1])});
        while (texcoord_bits_ > 0 && std::round(std::ldexp(largest, texcoord_bits_)) > largest_texcoord) --texcoord_bits_;
        if (largest > largest_texcoord)
            baked_.warnings.push_back(fmt::format("The part '{}' repeats its texture {:.0f} times; beyond {} times it is drawn wrong.", part.name,
                                                  largest, largest_texcoord));
    }

    TexCoord16 place_at(uint32_t index) {
        if (!has_texcoords_) return {};
        const auto rounded = [&](double v) {
            const double code = std::clamp<double>(std::round(std::ldexp(v, texcoord_bits_)), -largest_texcoord, largest_texcoord);
            return static_cast<int16_t>(code);
        };
        return {rounded(model_.texcoords[index][0]), rounded(model_.texcoords[index][1])};
    }

    void note_errors(uint32_t index, const Vertex& vertex) {
        const double distance = length(lattice_.value(vertex.position) - model_.positions[index]);
        const double angle = angle_degrees(model_.normals[index], vertex.normal);
        baked_.max_position_error = std::max(baked_.max_position_error, distance);
        baked_.max_normal_error_degrees = std::max(baked_.max_normal_error_degrees, angle);
    }

    void add_part(const ModelPart& part, VertexOrder order) {
        if (order.sources.size() > max_mesh_vertices)
            throw input_error(
                "{}: the part '{}' has {} different vertices; expected at most {}, as indices have 16 bits. "
                "Reduce the model or give it several materials.",
                model_.source, part.name, order.sources.size(), max_mesh_vertices);
        BakedPart baked{.name = part.name, .triangles = std::move(order.triangles), .material = part.material, .maps = part.maps};
        if (has_texcoords_) baked.texcoord_bits = static_cast<int8_t>(texcoord_bits_);
        for (const uint32_t source : order.sources) {
            baked.positions.push_back(vertices_[source].position);
            baked.normals.push_back(vertices_[source].normal);
            if (!model_.colors.empty()) baked.colors.push_back(vertices_[source].color);
            if (has_texcoords_) baked.texcoords.push_back(vertices_[source].at);
        }
        baked.convex = is_convex(baked.positions, baked.triangles);
        baked_.parts.push_back(std::move(baked));
    }

    const Model& model_;
    BakedModel& baked_;
    Lattice lattice_;
    std::vector<Vertex> vertices_{};  // of the part at hand
    std::map<Vertex::Key, uint32_t> numbers_{};
    bool has_texcoords_ = false;  // the part at hand
    int texcoord_bits_ = 15;
};

}  // namespace

BakedModel quantize(const Model& model) {
    if (model.positions.empty()) throw input_error("{}: has no triangles; expected at least one.", model.source);
    BakedModel baked;
    baked.source = model.source;
    baked.warnings = model.warnings;
    Baker baker(model, baked);
    for (const ModelPart& part : model.parts) baker.bake(part);
    if (baked.parts.empty())
        throw input_error("{}: is so small that nothing is left after rounding to 2^-{}; scale it up.", model.source,
                          baked.fraction_bits);
    if (baked.degenerate_triangles > 0)
        baked.warnings.push_back(fmt::format("{} triangle{} lost all area by rounding to 16 bits and {} dropped.",
                                             baked.degenerate_triangles, baked.degenerate_triangles == 1 ? "" : "s",
                                             baked.degenerate_triangles == 1 ? "was" : "were"));
    return baked;
}

std::size_t BakedPart::flash_bytes() const {
    return positions.size() * sizeof(Position16) + normals.size() * sizeof(Normal14) + colors.size() * sizeof(Rgb) +
           texcoords.size() * sizeof(TexCoord16) +
           triangles.size() * sizeof(Triangle);
}

std::size_t BakedModel::flash_bytes() const {
    std::size_t sum = 0;
    for (const BakedPart& part : parts) sum += part.flash_bytes();
    return sum;
}

std::size_t BakedModel::vertex_count() const {
    std::size_t sum = 0;
    for (const BakedPart& part : parts) sum += part.positions.size();
    return sum;
}

std::size_t BakedModel::triangle_count() const {
    std::size_t sum = 0;
    for (const BakedPart& part : parts) sum += part.triangles.size();
    return sum;
}

Mesh mesh_of(const BakedModel& model, std::size_t index) {
    const BakedPart& part = model.parts.at(index);
    const auto view = []<class T>(const std::vector<T>& v) {
        return View<T>(v.data(), static_cast<uint32_t>(v.size()));
    };
    return {.positions = view(part.positions),
            .normals = view(part.normals),
            .colors = view(part.colors),
            .texcoords = view(part.texcoords),
            .triangles = view(part.triangles),
            .centre = model.centre,
            .fraction_bits = model.fraction_bits,
            .texcoord_bits = part.texcoord_bits,
            .convex = part.convex};
}

}  // namespace shade16::host
