// What the user asked for, checked: no string that still has to be understood.
#pragma once

#include <optional>
#include <string>

#include "shade16/pipeline/transform.hpp"
#include "shade16/scene/material.hpp"

namespace shade16::host {

enum class Engine { fixed, reference };
enum class OutputKind { y4m, png, raw };

struct RenderOptions {
    std::string model{}, output{};
    OutputKind kind = OutputKind::y4m;
    std::string tier = "mediump", format = "rgb565";
    std::optional<Shading> shading{};  // the material's own without it
    Engine engine = Engine::fixed;
    Viewport size{320, 240};
    int frames = 0;  // 0: as many as suit the kind of output
    int fps = 30;
    int band_rows = 0;  // 0: the whole frame at once
    bool quiet = false, verbose = false;
};

struct CompareOptions {
    std::string model{};
    std::string tier{};  // empty: every one
    std::optional<Shading> shading{};
    Viewport size{320, 240};
    int frames = 8;
    bool quiet = false;
};

struct BakeOptions {
    std::string model{}, output{}, name{};
    bool quiet = false;
};

}  // namespace shade16::host
