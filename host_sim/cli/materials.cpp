#include "host_sim/cli/materials.hpp"

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/gallery/material_sheet.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

namespace {

constexpr int max_output_px = 8192;

double value(Unorm16 v) { return v.raw / 65535.0; }
std::string color_text(const Rgb& c) { return fmt::format("{:.4f} {:.4f} {:.4f}", value(c.r), value(c.g), value(c.b)); }

std::string table_text() {
    std::string text = fmt::format("{:<16}{:<23}{:<23}{:<23}{:>9}  {:>5}\n", "name", "ambient", "diffuse", "specular",
                                   "shininess", "alpha");
    for (const NamedMaterial& row : classic_materials) {
        const Material& m = row.material;
        text += fmt::format("{:<16}{:<23}{:<23}{:<23}{:>9.3f}  {:>5.3f}\n", row.name, color_text(m.ambient_color()),
                            color_text(m.diffuse), color_text(m.specular), m.shininess.raw / 65536.0, value(m.alpha));
    }
    return text + "Colours from 0 to 1; alpha is kept and not drawn.\n";
}

void write_sheet(const MaterialsOptions& o, Viewport size) {
    if (const int longest = std::max(size.width, size.height); longest > max_output_px)
        throw input_error("--size {}x{}: makes a sheet of {} pixels; expected at most {}.", o.size.width, o.size.height,
                          longest, max_output_px);
    const auto writer = open_writer(o.output, size.width, size.height, 1, 1);
    writer->write(material_sheet(o.size, o.tier, o.shading));
    writer->finish();
}

}  // namespace

ExitCode materials(const MaterialsOptions& o) {
    const Viewport size = material_sheet_size(o.size);
    if (!o.output.empty()) write_sheet(o, size);
    if (o.json)
        print(materials_json(o));
    else if (o.output.empty())
        print(table_text());
    else if (!o.quiet)
        print(fmt::format("{}: {} materials, {}x{} pixels; alpha is kept and not drawn\n", o.output,
                          std::size(classic_materials), size.width, size.height));
    return ExitCode::ok;
}

}  // namespace shade16::host
