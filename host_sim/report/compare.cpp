#include "host_sim/report/compare.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/engine/unused_tables.hpp"
#include "host_sim/report/judge.hpp"
#include "host_sim/report/unrounded.hpp"
#include "host_sim/report/winners.hpp"

namespace shade16::host {

namespace {
glm::dvec3 levels(const glm::dvec3& difference) { return glm::abs(difference) * levels_of_full_scale; }
double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

template <class Lit>
glm::dvec3 color_of(const Lit& lit, int channel_bits) {
    if constexpr (requires { lit.luma; }) return glm::dvec3(lit.luma * std::ldexp(1.0, -channel_bits));
    else return glm::dvec3(lit.r, lit.g, lit.b) * std::ldexp(1.0, -channel_bits);
}

/// Verdicts on every vertex of one object, or on every face where it is flat.
template <PrecisionTier Tier, Channels Colors>
std::vector<Verdict> judge_object(RuntimeRenderer<Tier, Colors>& renderer, const reference::Scene& scene, const Frame& frame, uint32_t o) {
    constexpr int bits = ScreenVertex<Tier>::channel_bits;
    const PromisedLevels promise = promised<Tier>(bits);
    const Object& object = scene.values.objects[o];
    std::vector<Verdict> verdicts;
    if (detail::is_flat(object.material)) {
        for (uint32_t f = 0; f < object.mesh.triangles.count; ++f)
            verdicts.push_back(judge(color_of(renderer.lit_face(o, f), bits), reference::in_channels(reference::light_face(scene, frame, o, f), Colors), object.material, promise));
    } else {
        for (uint32_t v = 0; v < object.mesh.positions.count; ++v)
            verdicts.push_back(judge(color_of(renderer.lit_vertex(o, v), bits), reference::in_channels(reference::light_vertex(scene, frame, o, v), Colors), object.material, promise));
    }
    return verdicts;
}

/// A screen vertex's position in pixels from the top left.
template <PrecisionTier Tier>
glm::dvec2 position_px(const ScreenVertex<Tier>& v, Viewport viewport) {
    return {viewport.width / 2.0 + v.x / 16.0, viewport.height / 2.0 + v.y / 16.0};
}

/// The width of a format's codes, by channel, in levels.
template <PixelFormat Format>
glm::dvec3 code_levels() {
    const auto levels_of = [](int bits) { return levels_of_full_scale / ((1 << bits) - 1); };
    if constexpr (GrayFormat<Format>) return glm::dvec3(levels_of(Format::luma_bits));
    else return {levels_of(Format::red_bits), levels_of(Format::green_bits), levels_of(Format::blue_bits)};
}

/// The bound of stepping along a span, by channel, in levels.
template <PrecisionTier Tier, PixelFormat Format>
glm::dvec3 stepping_bound() {
    const bool packed = Tier::stepping == Stepping::packed && PackedFormat<Format>;
    const double codes = (packed ? packed_stepping_max_error_per_1024_code : exact_stepping_max_error_per_1024_code) / 1024.0;
    return codes * code_levels<Format>();
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

/// What a table promises in place of the tier: its own error and half a code of RGB565 (or a luma's 16 bits), and a highlight that begins
/// within an entry of N.L = 0.
PromisedLevels promised_of_table(const Material& material, Channels colors) {
    const double each = light_table_max_error(material.light_table, material.shininess).micro / 1e6;
    return {each, each, light_table_gate_per_1024 / 1024.0, colors == Channels::luma ? 0.01 : levels_of_full_scale / 62};
}

/// A pixel with light of its own: right if it is right for some place that is no farther off than coordinates may be.
void judge_pixel(Comparison& result, const glm::dvec3& shown, const reference::Scene& scene, const Frame& frame, uint32_t o, uint32_t f,
                 const reference::FacePoint& point, Viewport viewport, Channels colors, const PromisedLevels& promise) {
    const Object& object = scene.values.objects[o];
    const auto verdict_at = [&](const glm::dvec2& shift) {
        reference::FacePoint shifted = point;
        shifted.texel_shift = shift;
        return judge(shown, reference::light_surface(scene, frame, o, f, shifted, colors), object.material, promise);
    };
    const reference::FrameValues values(scene.values, frame);
    if (object.material.light_table != LightTable::none && obstacle_to_light_table(object, values.lights, values.camera) == nullptr) {
        reference::FacePoint mapped = point;
        mapped.on_table_map = true;
        const reference::LightParts parts = reference::light_surface(scene, frame, o, f, mapped, colors);
        const PromisedLevels own = promised_of_table(object.material, colors);
        Verdict v = judge(shown, parts, object.material, own);
        for (const reference::LightShare& share : parts.shares)  // four entries may show anything between the two sides of its step
            if (std::abs(share.n_dot_l) < own.gate) v.bound_levels += largest(levels(share.specular)) / 2;
        return result.tables.add(v.error_levels, v.bound_levels);
    }
    Verdict best = verdict_at({});
    const double interpolation =
        detail::is_phong(object.material) ? 0 : std::ldexp(lit_sample_max_error_a_pixel * levels_of_full_scale, -24) * std::max(viewport.width, viewport.height);
    best.bound_levels += interpolation;
    if (detail::has_texture(object) || detail::has_bump(object)) {
        const Verdict exact = best;
        const double e = texel_error(object, viewport) + 0x1p-15;  // of a bilinear weight
        double spread = 0;  // between texels colours run linearly: an error of place is one of colour
        for (const glm::dvec2& shift : {glm::dvec2(-e, -e), glm::dvec2(e, -e), glm::dvec2(-e, e), glm::dvec2(e, e)}) {
            Verdict other = verdict_at(shift);
            other.bound_levels += interpolation;
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

template <PixelFormat Unrounded, PrecisionTier Tier, Channels Colors>
void compare_pixels(Comparison& result, RuntimeRenderer<Tier, Colors>& renderer, const std::vector<std::vector<Verdict>>& verdicts,
                    const std::vector<FaceId>& winners, const reference::Scene& scene, const Frame& frame, Viewport viewport) {
    constexpr int channels = Colors == Channels::rgb ? 3 : 1;
    const std::vector<typename Unrounded::Pixel> pixels = renderer.template draw<Unrounded>();
    const glm::dvec3 stepping = stepping_bound<Tier, Unrounded>();
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
            const auto v = renderer.lit_vertex(o, index);
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
            const reference::FacePoint point{w, corner, weights_in_space(scene, frame, viewport, o, t, w), false, {}};
            judge_pixel(result, value_of<Unrounded>(pixels[i]), scene, frame, o, f, point, viewport, Colors, promised<Tier>(ScreenVertex<Tier>::channel_bits));
            continue;
        }
        const glm::dvec3 expected = w.x * verdict[0]->reference + w.y * verdict[1]->reference + w.z * verdict[2]->reference;
        const double vertex_bound = std::max({verdict[0]->bound_levels, verdict[1]->bound_levels, verdict[2]->bound_levels});
        const glm::dvec3 error = levels(value_of<Unrounded>(pixels[i]) - expected), bound = stepping + vertex_bound;
        for (int c = 0; c < channels; ++c) result.pixels.add(error[c], bound[c]);
    }
}

/// What a display shows of a pixel.
glm::dvec3 shown(uint16_t p) { return glm::dvec3(p >> 11, (p >> 5) & 63, p & 31) / glm::dvec3(31, 63, 31); }
template <int Bits>
glm::dvec3 shown_of(const typename UnroundedGray<Bits>::Pixel& p) {
    return glm::dvec3((p.luma >> 24) / ((1 << Bits) - 1.0));
}

/// The picture that a display would show, against the independent one.
template <PixelFormat Unrounded, PrecisionTier Tier, Channels Colors>
void compare_pictures(Comparison& result, RuntimeRenderer<Tier, Colors>& renderer, const std::vector<FaceId>& winners, const reference::Picture& picture) {
    constexpr bool is_gray = Colors == Channels::luma;  // whose codes are those of the unrounded pixels
    const auto pixels = renderer.template draw<std::conditional_t<is_gray, Unrounded, Rgb565>>();
    for (std::size_t i = 0; i < winners.size(); ++i) {
        if (winners[i].covered != picture.covered[i]) ++result.covered_by_one;
        if (!winners[i].covered || !picture.covered[i]) continue;
        ++result.covered_by_both;
        glm::dvec3 color;
        if constexpr (is_gray) color = shown_of<Unrounded::luma_bits>(pixels[i]);
        else color = shown(pixels[i]);
        result.picture.add(largest(levels(color - picture.color[i])), 0);
    }
}
}  // namespace

void ErrorFigures::add(double error, double bound) {
    largest = std::max(largest, error);
    sum += error;
    ++count;
    if (bound > 0) largest_of_bound = std::max(largest_of_bound, error / bound);
}

template <PrecisionTier Tier, PixelFormat Unrounded>
void compare_in(Comparison& result, const reference::Scene& exact, const reference::Scene& original, const Frame& frame, Viewport viewport) {
    constexpr Channels colors = channels_of_format<Unrounded>;
    const glm::dvec3 code = code_levels<Unrounded>(), stepping = stepping_bound<Tier, Unrounded>();
    result.widest_code_levels = largest(code), result.narrowest_code_levels = code.g, result.stepping_levels = largest(stepping);
    result.tier = Tier::name;
    result.promise_to_128 = Tier::promise.to_exponent_128.micro / 1e6;
    result.promise_to_1000 = Tier::promise.to_exponent_1000.micro / 1e6;
    RuntimeRenderer<Tier, colors> renderer(exact.values);
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
    compare_pixels<Unrounded>(result, renderer, verdicts, winners, exact, frame, viewport);
    compare_pictures<Unrounded>(result, renderer, winners, reference::draw(original, frame, viewport, colors));
}

template <PrecisionTier Tier>
void compare_frame(Comparison& result, const reference::Scene& exact, const reference::Scene& original, const Frame& frame, Viewport viewport,
                   const std::string& format) {
    result.format = is_gray(format) ? format : Rgb565::name;
    if (format == Gray8::name) return compare_in<Tier, UnroundedGray<8>>(result, exact, original, frame, viewport);
    if (format == Gray4::name) return compare_in<Tier, UnroundedGray<4>>(result, exact, original, frame, viewport);
    if (format == Mono1::name) return compare_in<Tier, UnroundedGray<1>>(result, exact, original, frame, viewport);
    compare_in<Tier, UnroundedRgb565>(result, exact, original, frame, viewport);
}

template void compare_frame<lowp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);
template void compare_frame<mediump>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);
template void compare_frame<highp>(Comparison&, const reference::Scene&, const reference::Scene&, const Frame&, Viewport, const std::string&);

}  // namespace shade16::host
