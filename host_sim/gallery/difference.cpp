#include "host_sim/gallery/difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "host_sim/engine/codes.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/reference/pipeline.hpp"
#include "host_sim/report/winners.hpp"

namespace shade16::host {

namespace {

/// Of RGB888, which steps as exactly.
struct UnroundedRgb888 {
    using Pixel = ByChannel<Channels::rgb, uint32_t>;
    static constexpr int red_bits = 8, green_bits = 8, blue_bits = 8;
    static constexpr Pixel pack(uint32_t, uint32_t, uint32_t) { return {}; }
    static constexpr Pixel from_q24(uint32_t r, uint32_t g, uint32_t b) { return {r, g, b}; }
};

/// In levels, without the half code that rounds.
glm::dvec3 levels_of(const UnroundedRgb888::Pixel& p) { return glm::dvec3(p.r, p.g, p.b) * 0x1p-24 - 0.5; }
glm::dvec3 levels_of(const UnroundedGray<8>::Pixel& p) { return glm::dvec3(p.luma * 0x1p-24 - 0.5); }

template <PixelFormat Unrounded>
ReferenceDifference measured(const AnimatedScene& scene, const Frame& frame, Viewport viewport) {
    constexpr Channels channels = channels_of_format<Unrounded>;
    RuntimeRenderer<mediump, channels> renderer(scene.scene());
    renderer.begin(frame, viewport);
    const auto pixels = renderer.template draw<Unrounded>();
    const std::vector<FaceId> winners = winning_faces(scene.scene(), frame, viewport);
    const reference::Picture exact = reference::draw(scene.unquantized(), frame, viewport, channels);

    ReferenceDifference d{.width = viewport.width, .height = viewport.height};
    d.levels.resize(pixels.size());
    d.covered_by_one.resize(pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        d.covered_by_one[i] = winners[i].covered != exact.covered[i];
        d.covered_by_one_alone += d.covered_by_one[i];
        if (!winners[i].covered || !exact.covered[i]) continue;
        const glm::dvec3 error = glm::abs(levels_of(pixels[i]) - 255.0 * glm::clamp(exact.color[i], 0.0, 1.0));
        d.levels[i] = std::max({error.r, error.g, error.b});
        d.largest_levels = std::max(d.largest_levels, d.levels[i]);
        sum += d.levels[i];
        ++d.covered_by_both;
    }
    if (d.covered_by_both > 0) d.mean_levels = sum / static_cast<double>(d.covered_by_both);
    return d;
}

}  // namespace

PictureDifference difference(const Image& a, const Image& b) {
    if (a.rgb.size() != b.rgb.size()) throw std::logic_error("pictures of one size are compared");
    PictureDifference d;
    std::size_t different = 0;
    int64_t sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        int levels = 0;
        for (std::size_t c = i; c < i + 3; ++c) levels = std::max(levels, std::abs(a.rgb[c] - b.rgb[c]));
        different += levels > 0, sum += levels;
        d.largest_levels = std::max(d.largest_levels, levels);
    }
    d.share = 3.0 * static_cast<double>(different) / static_cast<double>(a.rgb.size());
    if (different > 0) d.mean_levels = static_cast<double>(sum) / static_cast<double>(different);
    return d;
}

std::size_t ReferenceDifference::beyond(double limit_levels) const {
    return static_cast<std::size_t>(std::ranges::count_if(levels, [&](double l) { return l > limit_levels; }));
}

void ReferenceDifference::add(const ReferenceDifference& other) {
    const auto weight = [](const ReferenceDifference& d) { return static_cast<double>(d.covered_by_both); };
    const double sum = mean_levels * weight(*this) + other.mean_levels * weight(other);
    covered_by_both += other.covered_by_both, covered_by_one_alone += other.covered_by_one_alone;
    if (covered_by_both > 0) mean_levels = sum / weight(*this);
    largest_levels = std::max(largest_levels, other.largest_levels);
    levels.insert(levels.end(), other.levels.begin(), other.levels.end());
}

ReferenceDifference difference_from_reference(const AnimatedScene& scene, Angle elapsed, Viewport viewport,
                                              Component component, bool is_gray) {
    const std::vector<Pose> poses = scene.poses(elapsed);
    const Frame frame{.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = component};
    return is_gray ? measured<UnroundedGray<8>>(scene, frame, viewport)
                   : measured<UnroundedRgb888>(scene, frame, viewport);
}

}  // namespace shade16::host
