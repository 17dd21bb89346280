#include "host_sim/engine/turntable.hpp"

#include <cmath>

#include "host_sim/engine/fixed_turntable.hpp"
#include "host_sim/reference/pipeline.hpp"

namespace shade16::host {

namespace {

/// A channel's code: the nearest; or, where the format is dithered, as the threshold at (x, y) has it.
template <PixelFormat Format>
uint32_t code_at(double value, int bits, [[maybe_unused]] int32_t x, [[maybe_unused]] int32_t y) {
    const double exact = std::clamp(value, 0.0, 1.0) * ((1 << bits) - 1);
    if constexpr (DitheredFormat<Format>) {
        const double thresholds = Format::matrix.side * Format::matrix.side;
        return static_cast<uint32_t>(exact + (Format::matrix.thresholds[y & 7][x & 7] + 0.5) / thresholds);
    } else {
        return static_cast<uint32_t>(std::lround(exact));
    }
}

template <PixelFormat Format>
void put_rounded(typename Format::Pixel* row, const glm::dvec3& color, int32_t x, int32_t y) {
    const auto q24 = [&](double value, int bits) { return code_at<Format>(value, bits, x, y) << 24; };
    if constexpr (GrayFormat<Format>) {
        using Whole = std::conditional_t<Format::luma_bits == 8, Gray8, std::conditional_t<Format::luma_bits == 4, Gray4, Mono1>>;
        Place<Whole>(row, x, y).put(q24(color.g, Format::luma_bits));
    } else {
        row[x] = Format::pack(code_at<Format>(color.r, Format::red_bits, x, y), code_at<Format>(color.g, Format::green_bits, x, y),
                              code_at<Format>(color.b, Format::blue_bits, x, y));
    }
}

template <PixelFormat Format>
class ReferenceTurntable final : public Turntable {
public:
    ReferenceTurntable(const AnimatedScene& scene, Viewport viewport, Component component)
        : scene_(scene), viewport_(viewport), component_(component), original_(scene.unquantized()) {}

    Image draw(Angle turn) override {
        const std::vector<Pose> poses = scene_.poses(turn);
        const Frame frame{.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = component_};
        const reference::Picture picture = reference::draw(original_, frame, viewport_, channels_of_format<Format>);
        Image image = image_of<Format>(memory<Format>(picture), viewport_);
        image.rgb = image_of<Rgb888>(memory<Rgb888>(picture), viewport_).rgb;
        return image;
    }

private:
    template <PixelFormat To>
    std::vector<typename To::Pixel> memory(const reference::Picture& picture) const {
        const auto stride = static_cast<std::size_t>(pixels_a_row<To>(viewport_.width));
        std::vector<typename To::Pixel> pixels(stride * static_cast<std::size_t>(viewport_.height));
        for (int32_t y = 0; y < viewport_.height; ++y)
            for (int32_t x = 0; x < viewport_.width; ++x)
                put_rounded<To>(pixels.data() + static_cast<std::size_t>(y) * stride, picture.color[picture.index(x, y)], x, y);
        return pixels;
    }

    const AnimatedScene& scene_;
    Viewport viewport_;
    Component component_;
    reference::Scene original_;
};

}  // namespace

std::unique_ptr<Turntable> fixed_turntable(const AnimatedScene& scene, Viewport viewport, std::string_view tier,
                                           const TargetFormat& target, int band_rows, Component component) {
    return with_tier(tier, [&]<class Tier>(Tier) { return fixed_turntable_of<Tier>(scene, viewport, target, band_rows, component); });
}

std::unique_ptr<Turntable> reference_turntable(const AnimatedScene& scene, Viewport viewport, const TargetFormat& target, Component component) {
    return with_target(target, [&]<class Format>(Format) -> std::unique_ptr<Turntable> {
        return std::make_unique<ReferenceTurntable<Format>>(scene, viewport, component);
    });
}

}  // namespace shade16::host
