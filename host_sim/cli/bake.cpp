#include "host_sim/cli/bake.hpp"

#include <filesystem>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/model/bake_header.hpp"
#include "host_sim/model/identifier.hpp"
#include "host_sim/model/obj_import.hpp"
#include "host_sim/scene_file/bake_scene.hpp"
#include "host_sim/scene_file/read_scene.hpp"

namespace shade16::host {

namespace {

std::string name_of(const BakeOptions& o) {
    if (o.name.empty()) return std::filesystem::path(is_standard_output(o.output) ? o.model : o.output).stem().string();
    if (const std::string possible = identifier(o.name); possible != o.name)
        throw input_error("--name {}: is no C++ name; expected one such as {}.", o.name, possible);
    return o.name;
}

std::string model_text(const BakeOptions& o, const BakedModel& baked) {
    std::string text = fmt::format(
        "{}: {}, {}, {} bytes of flash\n"
        "  rounding moved positions by at most {:.3g} of the model's units, and normals by at most {:.3g} degrees\n",
        o.output, counted(baked.vertex_count(), "vertex", "vertices"),
        counted(baked.triangle_count(), "triangle", "triangles"), baked.flash_bytes(), baked.max_position_error,
        baked.max_normal_error_degrees);
    for (const BakedPart& part : baked.parts)
        text += fmt::format(
            "  {}: {}, {}, {}\n", part.name, counted(part.positions.size(), "vertex", "vertices"),
            counted(part.triangles.size(), "triangle", "triangles"),
            part.convex ? "convex: drawn alone it needs no depth buffer" : "not convex: needs a depth buffer");
    return text;
}

std::string scene_text(const BakeOptions& o, const LoadedScene& scene) {
    const MeshFigures sum = mesh_figures(scene);
    return fmt::format("{}: {}, {}, {} bytes of flash\n  {}, {}, {} of {}x{} pixels\n", o.output,
                       counted(sum.vertices, "vertex", "vertices"), counted(sum.triangles, "triangle", "triangles"),
                       sum.flash_bytes, counted(scene.scene().objects.count, "object", "objects"),
                       counted(scene.scene().lights.count, "light", "lights"),
                       counted(static_cast<std::size_t>(baked_frames(scene)), "frame", "frames"),
                       scene.description().output.size.width, scene.description().output.size.height);
}

void refuse_to_overwrite(const std::string& input, const std::string& output, const char* what) {
    std::error_code ignored;
    if (std::filesystem::equivalent(input, output, ignored))
        throw input_error("{}: is {}; expected another name for the header.", output, what);
}

void finish(const BakeOptions& o, const std::string& header, const std::string& result) {
    write_file(o.output, header);
    if (o.json || !o.quiet) print_beside(o.output, result);
}

ExitCode bake_model(const BakeOptions& o) {
    refuse_to_overwrite(o.model, o.output, "the model itself");
    const std::string name = name_of(o);
    const BakedModel baked = quantize(import_obj(o.model, o.crease));
    if (!o.quiet) print_warnings(baked.warnings);
    finish(o, bake_header(baked, name), o.json ? bake_json(o, baked) : model_text(o, baked));
    return ExitCode::ok;
}

ExitCode bake_scene(const BakeOptions& o) {
    refuse_to_overwrite(o.model, o.output, "the scene file itself");
    if (o.crease) throw crease_beside_scene_file();
    const std::string name = name_of(o);
    const LoadedScene scene(read_scene(o.model));
    for (const MeshDescription& mesh : scene.description().meshes)
        if (mesh.kind == ShapeKind::file)
            refuse_to_overwrite((std::filesystem::path(o.model).parent_path() / mesh.file).string(), o.output,
                                "a model of the scene");
    if (!o.quiet) print_warnings(scene.warnings());
    finish(o, bake_scene_header(scene, name), o.json ? bake_json(o, scene) : scene_text(o, scene));
    return ExitCode::ok;
}

}  // namespace

ExitCode bake(const BakeOptions& o) {
    if (o.output.empty()) throw input_error("--output: the name is empty; expected one such as mesh.hpp.");
    return is_scene_file(o.model) ? bake_scene(o) : bake_model(o);
}

}  // namespace shade16::host
