// What the user asked for, checked: no string that still has to be understood.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host_sim/cli/open_screen.hpp"
#include "host_sim/bounds/shard.hpp"
#include "host_sim/engine/formats.hpp"
#include "shade16/pipeline/transform.hpp"
#include "host_sim/engine/look.hpp"
#include "shade16/scene/scene.hpp"

namespace shade16::host {

enum class Engine { fixed, reference };
enum class OutputKind { y4m, apng, png, raw };

struct RenderOptions {
    std::string model{}, output{};
    OutputKind kind = OutputKind::y4m;
    std::string tier = "mediump";
    TargetFormat target{};
    Look look{};                       // what it does not say is the material's own
    std::optional<double> crease{};    // degrees; the model's own normals without it
    Component component = Component::all;
    Engine engine = Engine::fixed;
    Viewport size{320, 240};
    int frames = 0;  // 0: as many as suit the kind of output
    int fps = 30;
    int band_rows = 0;  // 0: the whole frame at once
    int scale = 1;      // each pixel of the frame becomes scale x scale of the output
    bool quiet = false, verbose = false, json = false;
    bool dump_scene = false;          // print the scene instead of drawing it
    std::set<std::string> given{};    // the options that were on the command line: a scene file fills in the others
};

struct CompareOptions {
    std::string model{};
    std::string tier{};  // empty: every one
    TargetFormat target{};  // compared before it is dithered
    Look look{};
    std::optional<double> crease{};
    Component component = Component::all;
    Viewport size{320, 240};
    int frames = 8;
    bool quiet = false, json = false;
    std::set<std::string> given{};  // as in RenderOptions
};

struct BakeOptions {
    std::string model{}, output{}, name{};
    std::optional<double> crease{};
    bool quiet = false, json = false;
};

struct PreviewOptions {
    std::string model{};
    std::string tier = "mediump";
    std::optional<std::string> format{}, dither{};  // a grey scene file's own without them, and 24 bits of any other
    Look look{};
    std::optional<double> crease{};
    Component component = Component::all;
    int frames = 0;  // 0: until somebody ends it
};

struct ShowOptions {
    PreviewOptions scene{};  // its format is the screen's, where that has one
    ScreenOptions screen{};
    int fps = 30;
    bool quiet = false;
    bool lists_panels = false, probes = false;  // instead of showing
    std::set<std::string> given{};              // as in RenderOptions
};

struct MaterialsOptions {
    std::string output{};  // empty: the table as text
    std::string tier = "mediump";
    std::optional<Shading> shading{};
    Viewport size{96, 96};  // of one sphere's picture
    bool quiet = false, json = false;
    std::set<std::string> given{};  // as in RenderOptions
};

struct GalleryOptions {
    std::string assets{}, output{};  // directories
    bool quiet = false, json = false;
};

struct ReportOptions {
    std::string subject{}, output{};  // output: a directory
    std::string only{};               // names that begin so
    bool full = false;                // every input
    bounds::Shard shard{};
    std::vector<std::string> merge{};  // read these instead of measuring
    bool quiet = false, json = false;
    std::set<std::string> given{};  // as in RenderOptions
};

struct InfoOptions {
    std::string model{};
    TargetFormat target{};
    Look look{};
    std::optional<double> crease{};
    Viewport size{320, 240};
    bool json = false;
    std::set<std::string> given{};  // as in RenderOptions
};

}  // namespace shade16::host
