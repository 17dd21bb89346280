#include "host_sim/engine/turntable.hpp"

#include <cmath>

#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/reference/pipeline.hpp"

namespace shade16::host {

namespace {

void append(std::vector<uint8_t>& bytes, const Rgb888::Pixel& p) { bytes.insert(bytes.end(), {p.r, p.g, p.b}); }

/// Low byte first, whatever this machine does: a file has one meaning.
void append(std::vector<uint8_t>& bytes, uint16_t p) {
    bytes.insert(bytes.end(), {static_cast<uint8_t>(p & 255), static_cast<uint8_t>(p >> 8)});
}

template <PrecisionTier Tier, PixelFormat Format>
class FixedTurntable final : public Turntable {
public:
    FixedTurntable(const AnimatedScene& scene, Viewport viewport, int band_rows, Component component)
        : scene_(scene), viewport_(viewport), band_rows_(band_rows), component_(component), renderer_(scene.scene()) {}

    Image draw(Angle turn) override {
        const std::vector<Pose> poses = scene_.poses(turn);
        renderer_.begin({.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = component_}, viewport_);
        Image image{viewport_.width, viewport_.height};
        for (const auto& pixel : renderer_.template draw<Format>(band_rows_)) {
            append(image.rgb, as_rgb888<Format>(pixel));
            append(image.raw, pixel);
        }
        return image;
    }

private:
    const AnimatedScene& scene_;
    Viewport viewport_;
    int band_rows_;
    Component component_;
    RuntimeRenderer<Tier> renderer_;
};

template <PixelFormat Format>
typename Format::Pixel rounded(const glm::dvec3& color) {
    const auto code = [](double value, int bits) {
        return static_cast<uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * ((1 << bits) - 1)));
    };
    return Format::pack(code(color.r, Format::red_bits), code(color.g, Format::green_bits),
                        code(color.b, Format::blue_bits));
}

template <PixelFormat Format>
class ReferenceTurntable final : public Turntable {
public:
    ReferenceTurntable(const AnimatedScene& scene, Viewport viewport, Component component)
        : scene_(scene), viewport_(viewport), component_(component), original_(scene.unquantized()) {}

    Image draw(Angle turn) override {
        const std::vector<Pose> poses = scene_.poses(turn);
        const Frame frame{.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = component_};
        Image image{viewport_.width, viewport_.height};
        for (const glm::dvec3& color : reference::draw(original_, frame, viewport_).color) {
            append(image.rgb, rounded<Rgb888>(color));
            append(image.raw, rounded<Format>(color));
        }
        return image;
    }

private:
    const AnimatedScene& scene_;
    Viewport viewport_;
    Component component_;
    reference::Scene original_;
};

}  // namespace

std::unique_ptr<Turntable> fixed_turntable(const AnimatedScene& scene, Viewport viewport, std::string_view tier,
                                           std::string_view format, int band_rows, Component component) {
    return with_tier(tier, [&]<class Tier>(Tier) {
        return with_format(format, [&]<class Format>(Format) -> std::unique_ptr<Turntable> {
            return std::make_unique<FixedTurntable<Tier, Format>>(scene, viewport, band_rows, component);
        });
    });
}

std::unique_ptr<Turntable> reference_turntable(const AnimatedScene& scene, Viewport viewport, std::string_view format,
                                               Component component) {
    return with_format(format, [&]<class Format>(Format) -> std::unique_ptr<Turntable> {
        return std::make_unique<ReferenceTurntable<Format>>(scene, viewport, component);
    });
}

}  // namespace shade16::host
