#include "host_sim/cli/open_scene.hpp"

#include "host_sim/model/obj_import.hpp"
#include "host_sim/scene_file/describe_model.hpp"
#include "host_sim/scene_file/dump_scene.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"
#include "host_sim/scene_file/read_scene.hpp"

namespace shade16::host {

namespace {

template <class Options>
OpenScene opened(const Options& o, std::optional<SceneDescription> file) {
    if (file) return {std::make_unique<LoadedScene>(*file, o.look), std::nullopt, *file};
    auto scene = std::make_unique<ModelScene>(import_obj(o.model, o.crease), o.size, o.look);
    const FitFigures fit = scene->figures();
    SceneDescription description = describe(*scene, o.model);
    description.meshes.front().crease_degrees = o.crease;
    return {std::move(scene), fit, std::move(description)};
}

template <class Options>
std::optional<SceneDescription> scene_file(const Options& o) {
    if (!is_scene_file(o.model)) return std::nullopt;
    if (o.crease) throw crease_beside_scene_file();
    return read_scene(o.model);
}

}  // namespace

Error crease_beside_scene_file() {
    return input_error("--crease: a scene file says it mesh by mesh; expected 'crease' below its [meshes].");
}

OpenScene open_scene(RenderOptions& o) {
    const auto file = scene_file(o);
    if (file) {
        const OutputSettings& output = file->output;
        const auto settle = [&](const char* option, auto& value, const auto& from_file) {
            if (!o.given.contains(option)) value = from_file;
        };
        settle("--size", o.size, output.size);
        settle("--tier", o.tier, output.tier);
        settle("--format", o.target.format, output.target.format);
        if (o.target.format != Rgb888::name) settle("--dither", o.target.dither, output.target.dither);  // it shows every level
        settle("--frames", o.frames, output.frames);
        settle("--fps", o.fps, output.fps);
        settle("--bands", o.band_rows, output.band_rows);
    }
    return opened(o, file);
}

OpenScene open_scene(CompareOptions& o) {
    const auto file = scene_file(o);
    if (file && !o.given.contains("--size")) o.size = file->output.size;
    if (file && !o.given.contains("--format")) o.target.format = file->output.target.format;
    return opened(o, file);
}

OpenScene open_scene(InfoOptions& o) {
    const auto file = scene_file(o);
    if (file && !o.given.contains("--size")) o.size = file->output.size;
    if (file && !o.given.contains("--format")) o.target.format = file->output.target.format;
    return opened(o, file);
}

OpenScene open_scene(const PreviewOptions& options, Viewport size) {
    InfoOptions o{options.model, {}, options.look, options.crease, size, false, {"--size"}};
    return open_scene(o);
}

std::string dumped(const OpenScene& scene, const RenderOptions& o) {
    if (!o.look.says_nothing())
        throw input_error("--dump-scene: a scene file says shading, normals and the like material by material; expected none of it beside it.");
    if (o.component != Component::all)
        throw input_error("--dump-scene: a scene file has no component; expected no --component beside it.");
    SceneDescription description = scene.description;
    description.output = {o.size, o.target, o.tier, o.frames, o.fps, o.band_rows};
    return dump_scene(description);
}

}  // namespace shade16::host
