#include "host_sim/cli/bake.hpp"

#include <filesystem>

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/model/bake_header.hpp"
#include "host_sim/model/identifier.hpp"
#include "host_sim/model/obj_import.hpp"
#include "host_sim/scene_file/loaded_scene.hpp"

namespace shade16::host {

namespace {

std::string name_of(const BakeOptions& o) {
    if (o.name.empty()) return std::filesystem::path(is_standard_output(o.output) ? o.model : o.output).stem().string();
    if (const std::string possible = identifier(o.name); possible != o.name)
        throw input_error("--name {}: is no C++ name; expected one such as {}.", o.name, possible);
    return o.name;
}

std::string result_text(const BakeOptions& o, const BakedModel& baked) {
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

}  // namespace

ExitCode bake(const BakeOptions& o) {
    if (o.output.empty()) throw input_error("--output: the name is empty; expected one such as mesh.hpp.");
    if (is_scene_file(o.model)) throw input_error("{}: is a scene file; expected a model such as teapot.obj.", o.model);
    std::error_code ignored;
    if (std::filesystem::equivalent(o.model, o.output, ignored))
        throw input_error("{}: is the model itself; expected another name for the header.", o.output);
    const std::string name = name_of(o);
    const BakedModel baked = quantize(import_obj(o.model));
    if (!o.quiet) print_warnings(baked.warnings);
    write_file(o.output, bake_header(baked, name));
    if (o.json) print_beside(o.output, bake_json(o, baked));
    else if (!o.quiet) print_beside(o.output, result_text(o, baked));
    return ExitCode::ok;
}

}  // namespace shade16::host
