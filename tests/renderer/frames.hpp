// Frames of the renderer's tests: of scenes compiled in, and of the same at run time.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "host_sim/engine/runtime_renderer.hpp"
#include "tests/renderer/scenes.hpp"

namespace shade16::host {

inline constexpr Viewport screen{96, 72};

template <class Renderer, class Format>
std::vector<typename Format::Pixel> frame_of(Renderer& renderer, int32_t rows = screen.height) {
    std::vector<typename Format::Pixel> pixels(static_cast<std::size_t>(screen.width * screen.height));
    std::vector<uint16_t> depth(static_cast<std::size_t>(screen.width * rows));
    renderer.begin({}, screen);
    for (int32_t y = 0; y < screen.height; y += rows)
        renderer.draw(Band<Format>{pixels.data() + y * screen.width, depth.data(), screen.width, y, std::min(rows, screen.height - y)});
    return pixels;
}

template <const Scene& scene, class Tier, VertexStore Store = VertexStore::keep, Needs Have = needs_of(scene), uint32_t Slots = 64>
std::vector<Rgb565::Pixel> compiled(int32_t rows = screen.height) {
    auto memory = std::make_unique<Workspace<scene, Tier, Store, Slots>>();
    Renderer<scene, Tier, Store, Have> renderer(*memory);
    return frame_of<decltype(renderer), Rgb565>(renderer, rows);
}

template <class Tier>
std::vector<Rgb565::Pixel> at_run_time(const Scene& scene) {
    RuntimeRenderer<Tier> renderer(scene);
    renderer.begin({}, screen);
    return renderer.template draw<Rgb565>();
}

}  // namespace shade16::host
