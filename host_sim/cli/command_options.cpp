#include "host_sim/cli/command_options.hpp"

#include <CLI/CLI.hpp>

#include "host_sim/cli/values.hpp"

namespace shade16::host {

namespace {

using Setter = std::function<void(const std::string&)>;

/// An option with a value, which `set` understands. Given twice, the last one counts.
CLI::Option* add(CLI::App& app, const char* name, const char* type, const char* help, const Setter& set) {
    return app.add_option_function<std::string>(name, set, help)
        ->type_name(type)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void add_word(CLI::App& app, const char* name, const char* type, std::string& word, const char* help) {
    add(app, name, type, help, [&word](const std::string& given) { word = given; });
}

void add_flag(CLI::App& app, const char* name, bool& is_given, const char* help) {
    app.add_flag(name, is_given, help)->disable_flag_override();
}

void add_json(CLI::App& app, bool& is_wanted) {
    add_flag(app, "--json", is_wanted, "print the figures as one JSON object");
}

void add_scene(CLI::App& app, std::string& model,
               const char* help = "a scene file (.toml), or a Wavefront OBJ file to be fitted into the frame") {
    app.add_option("SCENE", model, help)->required()->type_name("");
}

void add_tier(CLI::App& app, std::string& tier, const char* help) {
    add(app, "--tier", "WORD", help, [&](const std::string& word) { tier = tier_of(word); });
}

template <class Word>
void add_format(CLI::App& app, Word& format, const char* help) {
    add(app, "--format", "WORD", help, [&](const std::string& word) { format = format_of(word); });
}

template <class Word>
void add_dither(CLI::App& app, Word& dither, const char* help) {
    add(app, "--dither", "WORD", help, [&](const std::string& word) { dither = dither_of(word); });
}

void add_shading(CLI::App& app, std::optional<Shading>& shading) {
    add(app, "--shading", "WORD", "flat, gouraud or phong [the material's]",
        [&](const std::string& word) { shading = shading_of(word); });
}

/// What is said of every material at once.
void add_material_look(CLI::App& app, Look& look) {
    add_shading(app, look.shading);
    add(app, "--normals", "WORD", "with phong: linear or spherical [the material's]", [&](const std::string& word) { look.normals = normals_of(word); });
    add(app, "--reflection", "WORD", "highlights: blinn_phong or phong [the material's]",
        [&](const std::string& word) { look.reflection = reflection_of(word); });
    add(app, "--light-table", "WORD", "with phong, by a table of light: none, nearest or bilinear [the material's]",
        [&](const std::string& word) { look.light_table = light_table_of(word); });
    add(app, "--filter", "WORD", "of textures: nearest or bilinear [the material's]", [&](const std::string& word) { look.filter = filter_of(word); });
    add(app, "--mapping", "WORD", "of textures: affine or perspective [the material's]",
        [&](const std::string& word) { look.mapping = mapping_of(word); });
}

void add_crease(CLI::App& app, std::optional<double>& crease) {
    add(app, "--crease", "ANGLE", "normals from the faces, which keep edges sharper than so many degrees [the model's]",
        [&](const std::string& word) { crease = crease_of(word); });
}

void add_component(CLI::App& app, Component& component) {
    add(app, "--component", "WORD", "of the light: all, or ambient, diffuse or specular alone [all]",
        [&](const std::string& word) { component = component_of(word); });
}

template <class Options>
void add_look(CLI::App& app, Options& o) {
    add(app, "--size", "WxH", "pixels [320x240]", [&](const std::string& word) { o.size = size_of(word); });
    add_material_look(app, o.look);
    add_crease(app, o.crease);
}

}  // namespace

void add_render(CLI::App& app, RenderOptions& o) {
    add_scene(app, o.model);
    add(app, "-o,--output", "OUT", ".y4m, .apng, .png, or raw as .rgb565, .gray8, .gray4, .mono1; '-' is Y4M on standard output",
        [&](const std::string& path) {
            o.kind = kind_of(path);
            o.output = path;
        });
    add(app, "--frames", "N", "of one turn [1; 90 for Y4M and APNG]",
        [&](const std::string& word) { o.frames = whole_number("--frames", word, 1, 100'000); });
    add(app, "--fps", "N", "frames a second, noted in Y4M and APNG [30]",
        [&](const std::string& word) { o.fps = whole_number("--fps", word, 1, 1000); });
    add_tier(app, o.tier, "lowp, mediump or highp [mediump]");
    add_format(app, o.target.format, "the display's: rgb565, rgb565_swapped, rgb888, gray8, gray4 or mono1 [rgb565]");
    add_dither(app, o.target.dither, "none, 4x4 or 8x8: how colours between the format's codes are shown [none]");
    add(app, "--bands", "ROWS", "draw in bands of so many rows, as with little RAM [all at once]",
        [&](const std::string& word) { o.band_rows = whole_number("--bands", word, 1, 2048); });
    add(app, "--engine", "WORD", "fixed, or reference: double precision without tiers and bands [fixed]",
        [&](const std::string& word) { o.engine = engine_of(word); });
    add_look(app, o);
    add_component(app, o.component);
    add(app, "--scale", "N", "show every pixel as N x N pixels, 1 to 16 [1]",
        [&](const std::string& word) { o.scale = whole_number("--scale", word, 1, 16); });
    add_flag(app, "--quiet", o.quiet, "print errors only");
    add_flag(app, "--verbose", o.verbose, "print what the fitted camera and lights came to");
    add_flag(app, "--dump-scene", o.dump_scene, "print the scene as a scene file instead of drawing it");
    add_json(app, o.json);
}

void add_compare(CLI::App& app, CompareOptions& o) {
    add_scene(app, o.model);
    add_tier(app, o.tier, "lowp, mediump or highp [all three]");
    add_format(app, o.target.format, "what is shown, as of 'shade16 render'; compared before it is dithered [rgb565]");
    add(app, "--frames", "N", "of one turn [8]",
        [&](const std::string& word) { o.frames = whole_number("--frames", word, 1, 100'000); });
    add_look(app, o);
    add_component(app, o.component);
    add_flag(app, "--quiet", o.quiet, "print no warnings and no progress");
    add_json(app, o.json);
}

void add_bake(CLI::App& app, BakeOptions& o) {
    add_scene(app, o.model, "a scene file (.toml), or a Wavefront OBJ file");
    add(app, "-o,--output", "HEADER", "the header to write; '-' is standard output", [&](const std::string& path) {
        o.output = path;
    })->required();
    add(app, "--name", "NAME", "of the mesh or the scene in C++ [the header's]",
        [&](const std::string& name) { o.name = name; });
    add_crease(app, o.crease);
    add_flag(app, "--quiet", o.quiet, "print errors only");
    add_json(app, o.json);
}

void add_info(CLI::App& app, InfoOptions& o) {
    add_scene(app, o.model);
    add_format(app, o.target.format, "the display's, as of 'shade16 render' [rgb565]");
    add_look(app, o);
    add_json(app, o.json);
}

void add_preview(CLI::App& app, PreviewOptions& o) {
    add_scene(app, o.model);
    add(app, "--frames", "N", "stop after so many, 90 a turn [until q or Ctrl-C]",
        [&](const std::string& word) { o.frames = whole_number("--frames", word, 1, 100'000); });
    add_tier(app, o.tier, "lowp, mediump or highp [mediump]");
    add_format(app, o.format, "as a display of that format shows it, as of 'shade16 render' [rgb888; a grey scene's own]");
    add_dither(app, o.dither, "none, 4x4 or 8x8 [none; a grey scene's own]");
    add_material_look(app, o.look);
    add_crease(app, o.crease);
    add_component(app, o.component);
}

void add_show(CLI::App& app, ShowOptions& o) {
    ScreenOptions& s = o.screen;
    app.add_option("SCENE", o.scene.model, "a scene file (.toml), or a Wavefront OBJ file to be fitted into the frame")->type_name("");
    add(app, "--board", "WORD", "linux_spi, fbdev or terminal [linux_spi]",
        [&](const std::string& word) { s.kind = screen_kind_of(word); });
    add_word(app, "--panel", "NAME", s.panel, "one of --list-panels, or a file (.txt) [ili9341]");
    add(app, "--rotate", "DEGREES", "0, 90, 180 or 270, clockwise [0]",
        [&](const std::string& word) { s.quarter_turns = quarter_turns_of(word); });
    add_flag(app, "--mirror", s.mirrored, "left and right exchanged");
    add_word(app, "--dc", "LINE", s.wires.command, "the data/command line: GPIO25, 25 (no pin of the header), or gpiochip0:25");
    add_word(app, "--reset", "LINE", s.wires.reset, "the reset line, where the panel has one");
    add_word(app, "--backlight", "LINE", s.wires.backlight, "the backlight's line, where there is one");
    add_word(app, "--spi", "DEVICE", s.wires.spi.device, "spidev's [/dev/spidev0.0]");
    add(app, "--spi-hz", "N", "its clock, such as 32M [32M]; lower it where pictures break up",
        [&](const std::string& word) { s.wires.spi.hz = hz_of(word); });
    add(app, "--spi-mode", "N", "0, or 3 for some panels without a select line [0]",
        [&](const std::string& word) { s.wires.spi.mode = spi_mode_of(word); });
    add_word(app, "--clock", "LINE", s.wires.clock, "with --data: bits line by line, where there is no SPI");
    add_word(app, "--data", "LINE", s.wires.data, "see --clock");
    add_word(app, "--select", "LINE", s.wires.select, "with --clock: the panel's select line, where it has one");
    add_word(app, "--framebuffer", "DEVICE", s.framebuffer, "of --board fbdev [/dev/fb0]");
    add(app, "--fps", "N", "frames a second at most [30]", [&](const std::string& word) { o.fps = whole_number("--fps", word, 1, 1000); });
    add(app, "--frames", "N", "stop after so many, 90 a turn [until Ctrl-C]",
        [&](const std::string& word) { o.scene.frames = whole_number("--frames", word, 1, 100'000'000); });
    add_flag(app, "--off", s.wires.is_dark_at_end, "switch panel and backlight off at the end");
    add_flag(app, "--dry-run", s.dry_run, "print what the panel would be sent, for --frames or for ever");
    add_flag(app, "--list-panels", o.lists_panels, "print the panels and end");
    add_flag(app, "--probe", o.probes, "print what is there and what is missing, with the command that brings it, and end; takes each line for a moment");
    add_tier(app, o.scene.tier, "lowp, mediump or highp [mediump]");
    add_dither(app, o.scene.dither, "none, 4x4 or 8x8 [none]");
    add_material_look(app, o.scene.look);
    add_crease(app, o.scene.crease);
    add_component(app, o.scene.component);
    add_flag(app, "--quiet", o.quiet, "print errors only");
}

void add_materials(CLI::App& app, MaterialsOptions& o) {
    add(app, "-o,--output", "OUT", "a picture (.png) of all of them as spheres; without it the table is printed",
        [&](const std::string& path) { o.output = picture_of(path); });
    add_tier(app, o.tier, "lowp, mediump or highp [mediump]");
    add(app, "--size", "WxH", "pixels of one sphere's picture [96x96]",
        [&](const std::string& word) { o.size = size_of(word); });
    add_shading(app, o.shading);
    add_flag(app, "--quiet", o.quiet, "print errors only");
    add_json(app, o.json);
}

void add_gallery(CLI::App& app, GalleryOptions& o) {
    app.add_option("ASSETS", o.assets, "the directory of the project's models and scenes")->required()->type_name("");
    add(app, "-o,--output", "DIRECTORY", "where the pictures go", [&](const std::string& path) {
        o.output = path;
    })->required();
    add_flag(app, "--quiet", o.quiet, "print errors only");
    add_json(app, o.json);
}

void add_report(CLI::App& app, ReportOptions& o) {
    app.add_option_function<std::string>("SUBJECT", [&](const std::string& word) { o.subject = subject_of(word); }, "what it is about: bounds")->required()->type_name("");
    add(app, "-o,--output", "DIRECTORY", "where bounds.html, bounds.json and bounds.md go; it is made where there is none", [&](const std::string& path) {
        o.output = path;
    })->required();
    add_flag(app, "--full", o.full, "measure every input: hours, not minutes");
    add(app, "--shard", "I/N", "with --full: the I-th of N shares, from 0", [&](const std::string& word) { o.shard = shard_of(word); });
    app.add_option("--merge", o.merge, "the bounds.json of every shard, instead of measuring")->type_name("FILE...");
    add(app, "--only", "NAME", "functions whose names begin so", [&](const std::string& word) { o.only = word; });
    add_flag(app, "--quiet", o.quiet, "print errors only");
    add_json(app, o.json);
}

}  // namespace shade16::host
