// The output and the camera.
#include "host_sim/scene_file/decimal.hpp"
#include "host_sim/scene_file/read_parts.hpp"

namespace shade16::host {

namespace {

constexpr Range distances{0.001, 16384}, angles{0.001, 179.999};

void refuse_impossible(const TableReader& table, const Camera& camera) {
    if (camera.eye == camera.target) throw table.wrong("target", "is where the eye is; expected another point");
    if (camera.up == Vec3{}) throw table.wrong("up", "has no length; expected a direction such as [0, 1, 0]");
    if (camera.far_distance <= camera.near_distance)
        throw table.wrong("far", fmt::format("is {}; expected more than near, which is {}",
                                             decimal(camera.far_distance), decimal(camera.near_distance)));
}

}  // namespace

OutputSettings read_output(const SceneTables& tables, const TomlValue& value) {
    const TableReader table = tables.reader("the output", value, {"size", "format", "dither", "tier", "frames", "fps", "bands"});
    const std::vector<std::string> tiers{lowp::name, mediump::name, highp::name};
    OutputSettings output;
    table.read("size", output.size);
    if (const auto i = table.word("format", format_names)) output.target.format = format_names[*i];
    if (const auto i = table.word("dither", dither_names)) output.target.dither = dither_names[*i];
    if (output.target.format == Rgb888::name && output.target.dither != dither_names[0])
        throw table.wrong("dither", "is more than rgb888 needs, which shows every level there is; expected \"none\"");
    if (const auto i = table.word("tier", tiers)) output.tier = tiers[*i];
    table.read("frames", output.frames, 1, 100'000);
    table.read("fps", output.fps, 1, 1000);
    table.read("bands", output.band_rows, 1, max_target_px);
    return output;
}

Camera read_camera(const SceneTables& tables, const TomlValue& value) {
    const TableReader table = tables.reader(
        "the camera", value, {"eye", "target", "up", "projection", "viewer", "fov", "view_height", "near", "far"});
    Camera camera;
    table.read("eye", camera.eye, coordinates);
    table.read("target", camera.target, coordinates);
    table.read("up", camera.up, coordinates);
    if (const auto i = table.word("projection", {"perspective", "orthographic"}))
        camera.projection = *i == 0 ? Projection::perspective : Projection::orthographic;
    if (const auto i = table.word("viewer", {"infinite", "local"}))
        camera.viewer = *i == 0 ? Viewer::infinite : Viewer::local;
    if (table.has("fov")) {
        double degrees = 0;
        table.read("fov", degrees, angles);
        camera.fov_y = degrees_of(degrees);
    }
    table.read("view_height", camera.view_height, distances);
    table.read("near", camera.near_distance, distances);
    table.read("far", camera.far_distance, distances);
    refuse_impossible(table, camera);
    return camera;
}

}  // namespace shade16::host
