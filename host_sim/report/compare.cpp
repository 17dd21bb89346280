#include "host_sim/report/compare.hpp"

#include <algorithm>
#include <array>

#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/report/judge.hpp"
#include "host_sim/report/unrounded.hpp"
#include "host_sim/report/winners.hpp"

namespace shade16::host {

namespace {
glm::dvec3 levels(const glm::dvec3& difference) { return glm::abs(difference) * levels_of_full_scale; }
double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

template <class Lit>
glm::dvec3 color_of(const Lit& lit, int channel_bits) {
    return glm::dvec3(lit.r, lit.g, lit.b) * std::ldexp(1.0, -channel_bits);
}

/// Verdicts on every vertex of one object, or on every face where it is flat.
template <PrecisionTier Tier>
std::vector<Verdict> judge_object(RuntimeRenderer<Tier>& renderer, const reference::Scene& scene, const Frame& frame, uint32_t o) {
    constexpr int bits = ScreenVertex<Tier>::channel_bits;
    const PromisedLevels promise = promised<Tier>(bits);
    const Object& object = scene.values.objects[o];
    std::vector<Verdict> verdicts;
    if (detail::is_flat(object.material)) {
        for (uint32_t f = 0; f < object.mesh.triangles.count; ++f)
            verdicts.push_back(judge(color_of(renderer.lit_face(o, f), bits), reference::light_face(scene, frame, o, f), object.material, promise));
    } else {
        for (uint32_t v = 0; v < object.mesh.positions.count; ++v)
            verdicts.push_back(judge(color_of(renderer.lit_vertex(o, v), bits), reference::light_vertex(scene, frame, o, v), object.material, promise));
    }
    return verdicts;
}

/// A screen vertex's position in pixels from the top left.
template <PrecisionTier Tier>
glm::dvec2 position_px(const ScreenVertex<Tier>& v, Viewport viewport) {
    return {viewport.width / 2.0 + v.x / 16.0, viewport.height / 2.0 + v.y / 16.0};
}

/// The bound of stepping along a span, by channel, in levels.
glm::dvec3 stepping_bound(bool packed) {
    const double codes = (packed ? packed_stepping_max_error_per_1024_code : exact_stepping_max_error_per_1024_code) / 1024.0;
    return codes * levels_of_full_scale / glm::dvec3(31, 63, 31);
}

/// Weights on the screen as weights before projection.
glm::dvec3 weights_in_space(const reference::Scene& scene, const Frame& frame, Viewport viewport, uint32_t o, const shade16::Triangle& t, const glm::dvec3& w) {
    const reference::FrameValues values(scene.values, frame);
    const reference::View view = reference::make_view(values.camera, viewport);
    const auto depth = [&](uint32_t corner) {
        return -reference::to_view(view, reference::to_world(values.pose(scene.values, o), scene.meshes[o].positions[corner])).z;
    };
    return w / glm::dvec3(depth(t.a), depth(t.b), depth(t.c));
}

/// The largest error of texture coordinates, in texels of the larger side.
double texel_error(const Object& object, Viewport viewport) {
    int log2 = 0;
    if (detail::has_texture(object)) log2 = std::max<int>(object.material.texture->width_log2, object.material.texture->height_log2);
    if (detail::has_bump(object)) log2 = std::max({log2, int{object.material.bump->width_log2}, int{object.material.bump->height_log2}});
    const bool perspective = object.material.mapping == Mapping::perspective;
    const int error_log2 = perspective ? perspective_coordinates_max_error_log2 : affine_coordinates_max_error_log2;
    return std::ldexp(std::max(1.0, std::max(viewport.width, viewport.height) / 256.0), log2 + 15 - object.mesh.texcoord_bits + error_log2);
}

/// A pixel with light of its own: right if it is right for some place that is no farther off than coordinates may be.
void judge_pixel(Comparison& result, const glm::dvec3& shown, const reference::Scene& scene, const Frame& frame, uint32_t o, uint32_t f,
                 const reference::FacePoint& point, Viewport viewport, const PromisedLevels& promise) {
    const Object& object = scene.values.objects[o];
    const auto verdict_at = [&](const glm::dvec2& shift) {
        reference::FacePoint shifted = point;
        shifted.texel_shift = shift;
        return judge(shown, reference::light_surface(scene, frame, o, f, shifted), object.material, promise);
    };
    Verdict best = verdict_at({});
    if (detail::has_texture(object) || detail::has_bump(object)) {
        const Verdict exact = best;
        const double e = texel_error(object, viewport) + 0x1p-15;  // of a bilinear weight
        double spread = 0;  // between texels colours run linearly: an error of place is one of colour
        for (const glm::dvec2& shift : {glm::dvec2(-e, -e), glm::dvec2(e, -e), glm::dvec2(-e, e), glm::dvec2(e, e)}) {
            const Verdict other = verdict_at(shift);
            spread = std::max(spread, largest(levels(other.reference - exact.reference)));
            if (other.error_levels < best.error_levels) best = other;
        }
        if (object.material.filter == Filter::bilinear) best = exact, best.bound_levels += spread;
        else if (exact.holds()) best = exact;
        ++result.textured_pixels;
        result.other_texel += object.material.filter == Filter::nearest && !exact.holds() && best.holds();
    }
    result.pixels.add(best.error_levels, best.bound_levels);
}

template <PrecisionTier Tier>
void compare_pixels(Comparison& result, RuntimeRenderer<Tier>& renderer, const std::vector<std::vector<Verdict>>& verdicts,
                    const std::vector<FaceId>& winners, const reference::Scene& scene, const Frame& frame, Viewport viewport) {
    constexpr bool packed = Tier::stepping == Stepping::packed;
    const std::vector<UnroundedRgb565::Pixel> pixels = renderer.template draw<UnroundedRgb565>();
    const glm::dvec3 stepping = stepping_bound(packed);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!winners[i].covered) continue;
        const auto [o, f, covered] = winners[i];
        const Object& object = scene.values.objects[o];
        const shade16::Triangle t = object.mesh.triangles[f];
        const bool flat = detail::is_flat(object.material);
        std::array<glm::dvec2, 3> corner;
        std::array<const Verdict*, 3> verdict{};
        bool clipped = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t index = k == 0 ? t.a : k == 1 ? t.b : t.c;
            const ScreenVertex<Tier> v = renderer.lit_vertex(o, index);
            clipped = clipped || (v.flags & outside_any);
            corner[k] = position_px(v, viewport);
            verdict[k] = &verdicts[o][flat ? f : index];
        }
        if (clipped) {
            ++result.clipped_pixels;
            continue;
        }
        const auto width = static_cast<std::size_t>(viewport.width);
        const glm::dvec3 w = reference::barycentric(corner, {double(i % width) + 0.5, double(i / width) + 0.5});
        if (reference::is_by_pixel(object)) {  // no stepping of colours: the light itself, at this very point
            const reference::FacePoint point{w, corner, weights_in_space(scene, frame, viewport, o, t, w), {}};
            judge_pixel(result, value(pixels[i]), scene, frame, o, f, point, viewport, promised<Tier>(ScreenVertex<Tier>::channel_bits));
            continue;
        }
        const glm::dvec3 expected = w.x * verdict[0]->reference + w.y * verdict[1]->reference + w.z * verdict[2]->reference;
        const double vertex_bound = std::max({verdict[0]->bound_levels, verdict[1]->bound_levels, verdict[2]->bound_levels});
        const glm::dvec3 error = levels(value(pixels[i]) - expected), bound = stepping + vertex_bound;
        for (int c = 0; c < 3; ++c) result.pixels.add(error[c], bound[c]);
    }
}

/// The picture that a display would show, against the independent one.
template <PrecisionTier Tier>
void compare_pictures(Comparison& result, RuntimeRenderer<Tier>& renderer, const std::vector<FaceId>& winners, const reference::Picture& picture) {
    const std::vector<uint16_t> pixels = renderer.template draw<Rgb565>();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (winners[i].covered != picture.covered[i]) ++result.covered_by_one;
        if (!winners[i].covered || !picture.covered[i]) continue;
        ++result.covered_by_both;
        const glm::dvec3 shown = glm::dvec3(pixels[i] >> 11, (pixels[i] >> 5) & 63, pixels[i] & 31) / glm::dvec3(31, 63, 31);
        result.picture.add(largest(levels(shown - picture.color[i])), 0);
    }
}
}  // namespace

void ErrorFigures::add(double error, double bound) {
    largest = std::max(largest, error);
    sum += error;
    ++count;
    if (bound > 0) largest_of_bound = std::max(largest_of_bound, error / bound);
}

template <PrecisionTier Tier>
void compare_frame(Comparison& result, const reference::Scene& exact, const reference::Scene& original, const Frame& frame, Viewport viewport) {
    result.tier = Tier::name;
    result.promise_to_128 = Tier::promise.to_exponent_128.micro / 1e6;
    result.promise_to_1000 = Tier::promise.to_exponent_1000.micro / 1e6;
    RuntimeRenderer<Tier> renderer(exact.values);
    renderer.begin(frame, viewport);

    std::vector<std::vector<Verdict>> verdicts;
    for (uint32_t o = 0; o < exact.values.objects.count; ++o) {
        verdicts.push_back(judge_object(renderer, exact, frame, o));
        for (const Verdict& v : verdicts.back()) {
            result.vertices.add(v.error_levels, v.bound_levels);
            result.beside_gate += v.beside_gate;
        }
    }
    const std::vector<FaceId> winners = winning_faces(exact.values, frame, viewport);
    compare_pixels(result, renderer, verdicts, winners, exact, frame, viewport);
    compare_pictures(result, renderer, winners, reference::draw(original, frame, viewport));
}

template void compare_frame<lowp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport);
template void compare_frame<mediump>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport);
template void compare_frame<highp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport);

}  // namespace shade16::host
