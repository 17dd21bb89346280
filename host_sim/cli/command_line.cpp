// The only file that includes CLI11, which takes a compiler ten seconds.
#include "host_sim/cli/command_line.hpp"

#include <CLI/CLI.hpp>

#include "host_sim/cli/help_text.hpp"
#include "host_sim/cli/usage.hpp"
#include "host_sim/cli/values.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

using Setter = std::function<void(const std::string&)>;

/// An option with a value, which `set` understands. Given twice, the last one counts.
CLI::Option* add(CLI::App& app, const char* name, const char* type, const char* help, const Setter& set) {
    return app.add_option_function<std::string>(name, set, help)
        ->type_name(type)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
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

/// Help that begins with examples; a list of commands has one line for each.
class ExamplesFirst final : public CLI::Formatter {
public:
    ExamplesFirst() { label("Positionals", "Arguments"); }

    std::string make_description(const CLI::App* app) const override {
        const std::string& name = app->get_name();
        const char* const begin = name == "render"    ? render_help
                                  : name == "compare" ? compare_help
                                  : name == "bake"    ? bake_help
                                  : name == "info"    ? info_help
                                  : name == "preview" ? preview_help
                                  : name == "materials" ? materials_help
                                  : name == "gallery" ? gallery_help
                                                      : program_help;
        return begin + std::string("\n");
    }
};

class CommandLine {
public:
    CommandLine() {
        app_.formatter(std::make_shared<ExamplesFirst>());  // before the commands, which inherit it
        app_.set_version_flag("--version", "shade16 " SHADE16_VERSION, "Print the version and exit");
        app_.require_subcommand(1);
        render_ = app_.add_subcommand("render", "draw a model: a picture, a film or raw pixels");
        compare_ = app_.add_subcommand("compare", "measure the engine against double precision");
        bake_ = app_.add_subcommand("bake", "turn a model or a scene into a C++ header");
        add_render(*render_, render_options_);
        add_compare(*compare_, compare_options_);
        info_ = app_.add_subcommand("info", "say what a model needs, and what it takes in flash and RAM");
        preview_ = app_.add_subcommand("preview", "show a model turning in the terminal");
        add_bake(*bake_, bake_options_);
        add_info(*info_, info_options_);
        add_preview(*preview_, preview_options_);
        materials_ = app_.add_subcommand("materials", "the 24 classic materials, as a table or as a picture");
        gallery_ = app_.add_subcommand("gallery", "draw the pictures of docs/gallery.md; for whoever changes the engine");
        add_materials(*materials_, materials_options_);
        add_gallery(*gallery_, gallery_options_);
        for (CLI::App* app : {&app_, render_, compare_, bake_, info_, preview_, materials_, gallery_}) app->footer(exit_codes_help);
    }

    Command parse(int argc, const char* const* argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            return Answer{app_.help()};
        } catch (const CLI::CallForVersion& version) {
            return Answer{version.what() + std::string("\n")};
        } catch (const CLI::ParseError& error) {
            throw input_error("{}", sentence(error));
        }
        render_options_.given = given_options(*render_);
        compare_options_.given = given_options(*compare_);
        info_options_.given = given_options(*info_);
        materials_options_.given = given_options(*materials_);
        if (render_->parsed()) return checked(render_options_);
        if (compare_->parsed()) return compare_options_;
        if (bake_->parsed()) return bake_options_;
        if (info_->parsed()) return info_options_;
        if (materials_->parsed()) return checked(materials_options_);
        if (gallery_->parsed()) return gallery_options_;
        return preview_options_;
    }

private:
    static std::set<std::string> given_options(const CLI::App& command) {
        std::set<std::string> names;
        for (const CLI::Option* option : command.get_options())
            if (option->count() > 0) names.insert(option->get_name());
        return names;
    }

    static const RenderOptions& checked(const RenderOptions& o) {
        if (o.output.empty() && !o.dump_scene)
            throw input_error(
                "the name of the output is missing: expected -o and a name; see 'shade16 render --help'.");
        if (!o.output.empty() && o.dump_scene)
            throw input_error(
                "--dump-scene: draws nothing and prints to standard output; expected no --output beside it.");
        return o;
    }

    /// What draws belongs to the picture.
    static const MaterialsOptions& checked(const MaterialsOptions& o) {
        for (const char* option : {"--size", "--tier", "--shading"})
            if (o.output.empty() && o.given.contains(option))
                throw input_error("{}: the table has none; expected -o and the name of a picture beside it.", option);
        return o;
    }

    /// The command that was given, or nullptr.
    const CLI::App* called() const {
        for (const CLI::App* app : {render_, compare_, bake_, info_, preview_, materials_, gallery_})
            if (app->parsed()) return app;
        return nullptr;
    }

    /// What CLI11 complains about, with what was expected. A word that nobody knows is named before anything that may
    /// only be missing because of it.
    std::string sentence(const CLI::ParseError& error) const {
        const CLI::App* const command = called();
        const std::string help = command ? "see 'shade16 " + command->get_name() + " --help'" : "see 'shade16 --help'";
        const std::vector<std::string> unknown = app_.remaining(true);
        for (const std::string& word : unknown)
            if (word.starts_with('-'))
                return unknown_word(word, "option", option_names(command ? *command : app_), help);
        if (command == nullptr && unknown.empty())
            return "a command is missing: expected " + listed(commands()) + "; " + help + ".";
        if (command == nullptr)
            return unknown_word(unknown.front(), "command", commands(), "expected " + listed(commands()) + "; " + help);
        if (!unknown.empty())
            return fmt::format("{}: is one word too many; expected {}; {}.", unknown.front(),
                               command == materials_ ? "options alone" : command == gallery_ ? "one directory" : "one model",
                               help);
        return reworded(error.get_name(), error.what()) + "; " + help + ".";
    }

    std::vector<std::string> commands() const {
        std::vector<std::string> names;
        for (const CLI::App* app : app_.get_subcommands({})) names.push_back(app->get_name());
        return names;
    }

    static std::vector<std::string> option_names(const CLI::App& app) {
        std::vector<std::string> names;
        for (const CLI::Option* option : app.get_options())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        return names;
    }

    CLI::App app_{"", "shade16"};
    CLI::App *render_ = nullptr, *compare_ = nullptr, *bake_ = nullptr, *info_ = nullptr, *preview_ = nullptr,
             *materials_ = nullptr, *gallery_ = nullptr;
    RenderOptions render_options_{};
    CompareOptions compare_options_{};
    BakeOptions bake_options_{};
    InfoOptions info_options_{};
    PreviewOptions preview_options_{};
    MaterialsOptions materials_options_{};
    GalleryOptions gallery_options_{};
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

}  // namespace shade16::host
