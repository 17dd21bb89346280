#include "host_sim/cli/info.hpp"

#include "host_sim/cli/console.hpp"
#include "host_sim/cli/json_text.hpp"
#include "host_sim/cli/open_scene.hpp"
#include "host_sim/report/memory.hpp"
#include "host_sim/report/terms.hpp"

namespace shade16::host {

namespace {

/// A model's objects are named after their materials; a scene file does not name its own.
std::vector<std::string> names(const AnimatedScene& scene) {
    std::vector<std::string> all;
    if (const auto* model = dynamic_cast<const ModelScene*>(&scene))
        for (const BakedPart& part : model->baked().parts) all.push_back(part.name);
    return all;
}

std::string objects_text(const Survey& s) {
    std::string text = fmt::format(
        "{}: {}, {}, {}, {}\n"
        "  extents: {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g}\n",
        s.source, counted(s.vertices, "vertex", "vertices"), counted(s.triangles, "triangle", "triangles"),
        counted(s.materials, "material", "materials"), counted(s.lights, "light", "lights"), s.low.x, s.low.y, s.low.z,
        s.high.x, s.high.y, s.high.z);
    for (const SurveyedObject& o : s.objects)
        text += fmt::format("  {}: {}, {}, {}\n", o.name, counted(o.vertices, "vertex", "vertices"),
                            counted(o.triangles, "triangle", "triangles"), o.convex ? "convex" : "not convex");
    if (s.translucent_objects > 0)
        text += fmt::format("  {} alpha below 1: alpha is kept and not drawn\n",
                            counted(s.translucent_objects, "object has", "objects have"));
    return text;
}

std::string needs_text(const Survey& s) {
    std::string paid = "\nNeeds\n", unpaid;
    for (const Term& term : terms) {
        if (s.needs.*term.is_needed)
            paid += fmt::format("  {:<21}{}\n", term.name, term.cost);
        else
            unpaid += fmt::format("  {:<21}{}\n", term.name, term.cost);
    }
    return paid + "\nDoes not pay for\n" + (unpaid.empty() ? "  nothing: it uses every term\n" : unpaid);
}

std::string memory_text(const Survey& s) {
    std::string text =
        fmt::format("\nFlash, estimated, without code\n  mesh {} bytes, {}and shininess tables as below\n", s.mesh_bytes,
                    s.picture_bytes == 0 ? "" : fmt::format("pictures {} bytes, ", s.picture_bytes));
    text += "\nBytes by tier     flash: shininess   RAM: vertices kept   RAM: replayed in ";
    text += fmt::format("{} slots\n", usual_replay_slots);
    for (const TierMemory& t : s.tiers)
        text += fmt::format("  {:<16}{:>16}{:>21}{:>25}\n", t.tier, t.shininess_bytes, t.keep_bytes, t.replay_bytes);
    text += fmt::format("  Counted on this computer; a 32-bit core needs about {} bytes less.\n",
                        (sizeof(void*) - 4) * s.objects.size());

    text += fmt::format("\nRAM of one band in {}, {} {} a pixel{}, {}x{} pixels\n", s.format,
                        s.bits_a_pixel, s.bits_a_pixel == 1 ? "bit" : "bits",
                        s.needs.depth ? " and 16 of depth" : ", no depth", s.viewport.width, s.viewport.height);
    for (const BandMemory& b : s.bands)
        text += fmt::format("  {:<8}{:>8} bytes{}\n", fmt::format("{} {}", b.rows, b.rows == 1 ? "row" : "rows"),
                            b.bytes, b.rows == s.viewport.height ? " (the whole frame)" : "");
    return text;
}

}  // namespace

ExitCode info(const InfoOptions& options) {
    InfoOptions o = options;
    const OpenScene open = open_scene(o);
    const AnimatedScene& scene = *open.scene;
    const Survey s = survey(scene.scene(), scene.source(), names(scene), o.size, o.target.format);
    if (o.json) {
        print(info_json(s, scene.warnings()));
        return ExitCode::ok;
    }
    print_warnings(scene.warnings());
    print(objects_text(s) + needs_text(s) + memory_text(s));
    return ExitCode::ok;
}

}  // namespace shade16::host
