// The fixed-point engine's turntable for one tier. One file a tier makes them, so that they compile side by side.
#pragma once

#include "host_sim/engine/codes.hpp"
#include "host_sim/engine/formats.hpp"
#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/engine/turntable.hpp"

namespace shade16::host {

inline void append(std::vector<uint8_t>& bytes, const Rgb888::Pixel& p) { bytes.insert(bytes.end(), {p.r, p.g, p.b}); }

/// Low byte first, whatever this machine does: a file has one meaning.
inline void append(std::vector<uint8_t>& bytes, uint16_t p) {
    bytes.insert(bytes.end(), {static_cast<uint8_t>(p & 255), static_cast<uint8_t>(p >> 8)});
}
inline void append(std::vector<uint8_t>& bytes, uint8_t p) { bytes.push_back(p); }

/// A frame's memory as a picture and as bytes.
template <PixelFormat Format>
Image image_of(const std::vector<typename Format::Pixel>& pixels, Viewport viewport) {
    Image image{viewport.width, viewport.height};
    if constexpr (GrayFormat<Format>) image.raw_bits = Format::luma_bits;
    for (int32_t y = 0; y < viewport.height; ++y) {
        const auto* const row = pixels.data() + std::ptrdiff_t{y} * pixels_a_row<Format>(viewport.width);
        for (int32_t x = 0; x < viewport.width; ++x) append(image.rgb, rgb888_at<Format>(row, x));
    }
    for (const auto& pixel : pixels) append(image.raw, pixel);
    return image;
}

template <PrecisionTier Tier, PixelFormat Format>
class FixedTurntable final : public Turntable {
public:
    FixedTurntable(const AnimatedScene& scene, Viewport viewport, int band_rows, Component component)
        : scene_(scene), viewport_(viewport), band_rows_(band_rows), component_(component), renderer_(scene.scene()) {}

    Image draw(Angle turn) override {
        const std::vector<Pose> poses = scene_.poses(turn);
        renderer_.begin({.camera = nullptr, .lights = nullptr, .poses = poses.data(), .component = component_}, viewport_);
        if constexpr (GrayFormat<Format> || DitheredFormat<Format>)
            return image_of<Format>(rounded_frame<Format>(renderer_.template draw<typename UnroundedOf<Format>::type>(band_rows_), viewport_,
                                                          scene_.scene().background),
                                    viewport_);
        else
            return image_of<Format>(renderer_.template draw<Format>(band_rows_), viewport_);
    }

private:
    const AnimatedScene& scene_;
    Viewport viewport_;
    int band_rows_;
    Component component_;
    RuntimeRenderer<Tier, channels_of_format<Format>> renderer_;
};

template <PrecisionTier Tier>
std::unique_ptr<Turntable> fixed_turntable_of(const AnimatedScene& scene, Viewport viewport, const TargetFormat& target,
                                              int band_rows, Component component) {
    return with_target(target, [&]<class Format>(Format) -> std::unique_ptr<Turntable> {
        return std::make_unique<FixedTurntable<Tier, Format>>(scene, viewport, band_rows, component);
    });
}

extern template std::unique_ptr<Turntable> fixed_turntable_of<lowp>(const AnimatedScene&, Viewport, const TargetFormat&, int, Component);
extern template std::unique_ptr<Turntable> fixed_turntable_of<mediump>(const AnimatedScene&, Viewport, const TargetFormat&, int, Component);
extern template std::unique_ptr<Turntable> fixed_turntable_of<highp>(const AnimatedScene&, Viewport, const TargetFormat&, int, Component);

}  // namespace shade16::host
