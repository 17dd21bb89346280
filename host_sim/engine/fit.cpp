#include "host_sim/engine/fit.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "host_sim/engine/runtime_renderer.hpp"
#include "host_sim/reference/transform.hpp"

namespace shade16::host {

namespace {
constexpr double wanted_cover = 0.66, wanted_saturation = 0.008;
constexpr int sampled_turns = 24, lit_turns = 8;
constexpr Viewport trial_viewport{160, 120};

Q16 q16(double v) { return Q16::from_raw(static_cast<int32_t>(std::lround(v * 65536))); }
Scaled scaled(double v) { return Scaled::normalized(static_cast<uint64_t>(std::lround(v * 65536)), -16); }

/// The distance of the farthest vertex from the centre, in the model's units.
double radius(const BakedModel& model) {
    double farthest = 0;
    for (const BakedPart& part : model.parts)
        for (const Position16& p : part.positions) farthest = std::max(farthest, std::hypot(double(p.x), double(p.y), double(p.z)));
    return std::ldexp(farthest, -model.fraction_bits);
}

Camera camera_at(double distance, double radius) {
    constexpr double elevation = 0.35;  // radians above the horizon
    Camera camera;
    camera.eye = {0, q16(distance * std::sin(elevation)), q16(distance * std::cos(elevation))};
    camera.fov_y = 36_deg;
    camera.viewer = Viewer::local;
    camera.near_distance = q16(std::max(distance - 1.1 * radius, distance / 64));
    camera.far_distance = q16(distance + 1.1 * radius);
    return camera;
}

/// The larger of the model's shares of the frame's width and height, at one turn.
double cover(const ModelScene& scene, const Camera& camera, Viewport viewport, Angle turn) {
    const reference::View view = reference::make_view(camera, viewport);
    const std::vector<Pose> poses = scene.poses(turn);
    glm::dvec2 low(1e9), high(-1e9);
    for (uint32_t o = 0; o < scene.scene().objects.count; ++o)
        for (const glm::dvec3& p : reference::value(scene.scene().objects[o].mesh).positions) {
            const auto point = reference::project(view, reference::to_view(view, reference::to_world(poses[o], p))).position;
            low = glm::min(low, point), high = glm::max(high, point);
        }
    return std::max((high.x - low.x) / viewport.width, (high.y - low.y) / viewport.height);
}

/// The least and the largest cover over a turn.
std::pair<double, double> covers_over_turn(const ModelScene& scene, const Camera& camera, Viewport viewport) {
    double least = 1e9, largest = 0;
    for (int i = 0; i < sampled_turns; ++i) {
        const double c = cover(scene, camera, viewport, turn_of(i, sampled_turns));
        least = std::min(least, c), largest = std::max(largest, c);
    }
    return {least, largest};
}

/// Brightness over a turn, as the fixed-point engine draws it.
void measure_light(const ModelScene& scene, FitFigures& figures) {
    RuntimeRenderer<mediump> renderer(scene.scene());
    figures.brightest_code = 0;
    figures.saturated_share = 0;
    const Rgb888::Pixel background = nearest_pixel<Rgb888>(scene.scene().background);
    for (int i = 0; i < lit_turns; ++i) {
        const std::vector<Pose> poses = scene.poses(turn_of(i, lit_turns));
        renderer.begin({.camera = nullptr, .lights = nullptr, .poses = poses.data()}, trial_viewport);
        int covered = 0, saturated = 0;
        for (const Rgb888::Pixel& p : renderer.draw<Rgb888>()) {
            if (p == background) continue;
            const int brightest = std::max({p.r, p.g, p.b});
            ++covered;
            saturated += brightest == 255;
            figures.brightest_code = std::max(figures.brightest_code, brightest);
        }
        if (covered > 0) figures.saturated_share = std::max(figures.saturated_share, double(saturated) / covered);
    }
}
}  // namespace

Q16 fitting_scale(const BakedModel& model) {
    const int power = -static_cast<int>(std::floor(std::log2(radius(model))));
    return Q16::from_raw(scale_by_power_of_two(65536, std::clamp(power, -14, 14)));
}

Camera fitting_camera(const ModelScene& scene, Viewport viewport, FitFigures& figures) {
    const double size = radius(scene.baked()) * reference::value(scene.poses({})[0].scale.x);
    double near = size * 1.05, far = size * 8000;
    for (int step = 0; step < 24; ++step) {
        const double middle = std::sqrt(near * far);
        (covers_over_turn(scene, camera_at(middle, size), viewport).second > wanted_cover ? near : far) = middle;
    }
    const Camera camera = camera_at(far, size);
    std::tie(figures.least_cover, figures.largest_cover) = covers_over_turn(scene, camera, viewport);
    return camera;
}

std::vector<Light> light_rig() {
    Light key = directional_light({-5, 5, 9});
    Light lamp = point_light({4, 1, 3}, rgb(0x9FB8FF), scaled(0.25));
    return {ambient_light(rgb(0x484848)), key, lamp};
}

Scaled fitting_key(const ModelScene& scene, Light& key, Viewport, FitFigures& figures) {
    double weak = 0.05, strong = 4;
    for (int step = 0; step < 12; ++step) {
        const double middle = (weak + strong) / 2;
        key.intensity = scaled(middle);
        measure_light(scene, figures);
        (figures.saturated_share > wanted_saturation ? strong : weak) = middle;
    }
    key.intensity = scaled(weak);
    measure_light(scene, figures);
    return key.intensity;
}

}  // namespace shade16::host
