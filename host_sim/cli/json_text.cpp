// The only file that includes nlohmann/json, which takes a compiler several seconds.
#include "host_sim/cli/json_text.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/cli/comparison_text.hpp"
#include "host_sim/gallery/heat_map.hpp"
#include "host_sim/gallery/material_sheet.hpp"
#include "host_sim/report/terms.hpp"
#include "host_sim/scene_file/bake_scene.hpp"

namespace shade16::host {

namespace {

using Json = nlohmann::ordered_json;

Json beginning(const char* command) { return {{"schema", 1}, {"command", command}}; }

/// The names of files need not be UTF-8, but JSON must be.
std::string finished(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json figures(const ErrorFigures& f) {
    return {{"largest_levels", f.largest},
            {"mean_levels", f.mean()},
            {"largest_share_of_bound", f.largest_of_bound},
            {"points", f.count},
            {"kept", f.holds()}};
}

Json comparison(const Comparison& c) {
    return {{"tier", c.tier},
            {"promise_levels", {{"to_exponent_128", c.promise_to_128}, {"to_exponent_1000", c.promise_to_1000}}},
            {"vertices", figures(c.vertices)},
            {"pixels", figures(c.pixels)},
            {"light_table_pixels", figures(c.tables)},
            {"clipped_pixels", c.clipped_pixels},
            {"textured_pixels", c.textured_pixels},
            {"neighbouring_texels", c.other_texel},
            {"picture",
             {{"largest_levels", c.picture.largest},
              {"mean_levels", c.picture.mean()},
              {"covered_by_one", c.covered_by_one},
              {"covered_by_both", c.covered_by_both}}},
            {"kept", c.holds()}};
}

Json needs(const Survey& s) {
    Json paid = Json::array(), unpaid = Json::array();
    for (const Term& term : terms) (s.needs.*term.is_needed ? paid : unpaid).push_back(term.name);
    return {{"needed", paid}, {"not_paid_for", unpaid}};
}

Json objects(const Survey& s) {
    Json all = Json::array();
    for (const SurveyedObject& o : s.objects)
        all.push_back({{"name", o.name}, {"vertices", o.vertices}, {"triangles", o.triangles}, {"convex", o.convex}});
    return all;
}

Json memory(const Survey& s) {
    Json tiers = Json::array(), bands = Json::array();
    for (const TierMemory& t : s.tiers)
        tiers.push_back({{"tier", t.tier},
                         {"flash_shininess_bytes", t.shininess_bytes},
                         {"ram_keep_bytes", t.keep_bytes},
                         {"ram_replay_bytes", t.replay_bytes}});
    for (const BandMemory& b : s.bands) bands.push_back({{"rows", b.rows}, {"bytes", b.bytes}});
    return {{"flash_mesh_bytes", s.mesh_bytes}, {"flash_picture_bytes", s.picture_bytes}, {"tiers", tiers}, {"bands", bands}};
}

Json color(const Rgb& c) { return {c.r.raw / 65535.0, c.g.raw / 65535.0, c.b.raw / 65535.0}; }

Json vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string render_json(const RenderOptions& o, const FitFigures* fit, int frames,
                        const std::vector<std::string>& warnings) {
    Json json = beginning("render");
    json["output"] = o.output;
    json["frames"] = frames;
    json["width"] = o.size.width * o.scale;
    json["height"] = o.size.height * o.scale;
    if (fit != nullptr)
        json["fit"] = {{"least_cover", fit->least_cover},
                       {"largest_cover", fit->largest_cover},
                       {"brightest_code", fit->brightest_code},
                       {"saturated_share", fit->saturated_share}};
    json["warnings"] = warnings;
    return finished(json);
}

std::string compare_json(const CompareOptions& o, const std::vector<Comparison>& tiers, const AnimatedScene& scene) {
    Json json = beginning("compare");
    json["source"] = scene.source();
    json["objects"] = scene.scene().objects.count;
    json["vertices"] = detail::vertex_count(scene.scene());
    json["lights"] = scene.scene().lights.count;
    json["frames"] = o.frames;
    json["width"] = o.size.width;
    json["height"] = o.size.height;
    json["format"] = o.target.format;
    json["verdict"] = verdict_of(tiers);
    json["tiers"] = Json::array();
    for (const Comparison& c : tiers) json["tiers"].push_back(comparison(c));
    json["warnings"] = scene.warnings();
    return finished(json);
}

std::string bake_json(const BakeOptions& o, const BakedModel& baked) {
    Json json = beginning("bake");
    json["output"] = o.output;
    json["vertices"] = baked.vertex_count();
    json["triangles"] = baked.triangle_count();
    json["flash_bytes"] = baked.flash_bytes();
    json["max_position_error"] = baked.max_position_error;
    json["max_normal_error_degrees"] = baked.max_normal_error_degrees;
    json["parts"] = Json::array();
    for (const BakedPart& part : baked.parts)
        json["parts"].push_back({{"name", part.name},
                                 {"vertices", part.positions.size()},
                                 {"triangles", part.triangles.size()},
                                 {"convex", part.convex}});
    json["warnings"] = baked.warnings;
    return finished(json);
}

std::string bake_json(const BakeOptions& o, const LoadedScene& scene) {
    const MeshFigures sum = mesh_figures(scene);
    Json json = beginning("bake");
    json["output"] = o.output;
    json["vertices"] = sum.vertices;
    json["triangles"] = sum.triangles;
    json["flash_bytes"] = sum.flash_bytes;
    json["objects"] = scene.scene().objects.count;
    json["lights"] = scene.scene().lights.count;
    json["frames"] = baked_frames(scene);
    json["width"] = scene.description().output.size.width;
    json["height"] = scene.description().output.size.height;
    json["warnings"] = scene.warnings();
    return finished(json);
}

std::string info_json(const Survey& s, const std::vector<std::string>& warnings) {
    Json json = beginning("info");
    json["source"] = s.source;
    json["vertices"] = s.vertices;
    json["triangles"] = s.triangles;
    json["materials"] = s.materials;
    json["lights"] = s.lights;
    json["extents"] = {{"low", vector(s.low)}, {"high", vector(s.high)}};
    json["objects"] = objects(s);
    json["needs"] = needs(s);
    json["width"] = s.viewport.width;
    json["height"] = s.viewport.height;
    json["format"] = s.format;
    json["memory"] = memory(s);
    json["objects_with_alpha_below_1"] = s.translucent_objects;
    json["warnings"] = warnings;
    return finished(json);
}

std::string materials_json(const MaterialsOptions& o) {
    Json json = beginning("materials");
    if (!o.output.empty()) {
        const Viewport size = material_sheet_size(o.size);
        json["output"] = o.output;
        json["width"] = size.width;
        json["height"] = size.height;
    }
    json["materials"] = Json::array();
    for (const NamedMaterial& row : classic_materials)
        json["materials"].push_back({{"name", row.name},
                                     {"ambient", color(row.material.ambient_color())},
                                     {"diffuse", color(row.material.diffuse)},
                                     {"specular", color(row.material.specular)},
                                     {"shininess", row.material.shininess.raw / 65536.0},
                                     {"alpha", row.material.alpha.raw / 65535.0}});
    json["alpha_is_drawn"] = false;
    json["warnings"] = Json::array();
    return finished(json);
}

std::string gallery_json(const std::vector<Plate>& plates) {
    Json json = beginning("gallery");
    json["pictures"] = Json::array();
    for (const Plate& plate : plates) {
        Json pairs = Json::array(), panels = Json::array();
        for (const Pair& p : plate.pairs)
            pairs.push_back({{"a", p.a},
                             {"b", p.b},
                             {"share", p.difference.share},
                             {"stated_share", p.stated_share},
                             {"mean_levels", p.difference.mean_levels},
                             {"largest_levels", p.difference.largest_levels},
                             {"kept", p.holds()}});
        for (const Panel& p : plate.panels)
            if (p.error)
                panels.push_back({{"name", p.name},
                                  {"mean_levels", p.error->mean_levels},
                                  {"largest_levels", p.error->largest_levels},
                                  {"beyond_scale", p.error->beyond(heat_scale_levels)},
                                  {"beyond_half_a_code_of_rgb565", p.error->beyond(half_code_levels)},
                                  {"covered_by_both", p.error->covered_by_both},
                                  {"covered_by_one", p.error->covered_by_one_alone}});
        json["pictures"].push_back({{"file", plate.file}, {"pairs", pairs}, {"against_reference", panels}});
    }
    json["warnings"] = Json::array();
    return finished(json);
}

}  // namespace shade16::host
