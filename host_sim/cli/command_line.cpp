// With command_options.cpp the only file that includes CLI11, which takes a compiler ten seconds.
#include "host_sim/cli/command_line.hpp"

#include <CLI/CLI.hpp>

#include "host_sim/cli/command_options.hpp"
#include "host_sim/cli/help_text.hpp"
#include "host_sim/cli/usage.hpp"
#include "host_sim/error.hpp"

namespace shade16::host {

namespace {

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
                                  : name == "show" ? show_help
                                  : name == "materials" ? materials_help
                                  : name == "gallery" ? gallery_help
                                  : name == "report" ? report_help
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
        show_ = app_.add_subcommand("show", "show a model on a panel at this computer's SPI, its framebuffer or in the terminal");
        add_show(*show_, show_options_);
        materials_ = app_.add_subcommand("materials", "the 24 classic materials, as a table or as a picture");
        gallery_ = app_.add_subcommand("gallery", "draw the pictures of docs/gallery.md; for whoever changes the engine");
        add_materials(*materials_, materials_options_);
        add_gallery(*gallery_, gallery_options_);
        report_ = app_.add_subcommand("report", "measure every bound that the engine promises: a page, JSON and a table");
        add_report(*report_, report_options_);
        for (CLI::App* app : {&app_, render_, compare_, bake_, info_, preview_, show_, materials_, gallery_, report_}) app->footer(exit_codes_help);
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
        show_options_.given = given_options(*show_);
        materials_options_.given = given_options(*materials_);
        report_options_.given = given_options(*report_);
        if (render_->parsed()) return checked(render_options_);
        if (compare_->parsed()) return compare_options_;
        if (bake_->parsed()) return bake_options_;
        if (info_->parsed()) return info_options_;
        if (show_->parsed()) return checked(show_options_);
        if (materials_->parsed()) return checked(materials_options_);
        if (gallery_->parsed()) return gallery_options_;
        if (report_->parsed()) return checked(report_options_);
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

    static void expect_different(const Wires& w) {
        const std::pair<const char*, const std::string&> lines[] = {{"--dc", w.command}, {"--reset", w.reset}, {"--backlight", w.backlight},
                                                                    {"--clock", w.clock}, {"--data", w.data},   {"--select", w.select}};
        for (const auto& [option, line] : lines)
            for (const auto& [other, others] : lines) {
                if (&line == &others) break;
                if (!line.empty() && line == others) throw input_error("{}: is the line of {}; expected another one.", option, other);
            }
    }

    static const ShowOptions& checked(const ShowOptions& o) {
        if (o.scene.model.empty() && !o.lists_panels && !o.probes)
            throw input_error("the scene is missing: expected a scene file or a model; see 'shade16 show --help'.");
        const auto belong = [&o](std::initializer_list<const char*> options, bool where, const char* to) {
            for (const char* option : options)
                if (!where && o.given.contains(option)) throw input_error("{}: belongs to {}; expected both, or neither.", option, to);
        };
        belong({"--panel", "--rotate", "--mirror", "--dc", "--reset", "--backlight", "--spi", "--spi-hz", "--spi-mode", "--clock", "--data", "--select", "--off",
                "--dry-run"},
               o.screen.kind == ScreenKind::linux_spi, "--board linux_spi");
        belong({"--framebuffer"}, o.screen.kind == ScreenKind::fbdev, "--board fbdev");
        belong({"--data", "--select"}, o.given.contains("--clock"), "--clock");
        belong({"--clock"}, o.given.contains("--data"), "--data");
        expect_different(o.screen.wires);
        for (const char* option : {"--spi", "--spi-hz", "--spi-mode"})
            if (o.given.contains("--clock") && o.given.contains(option))
                throw input_error("{}: --clock and --data take the place of SPI; expected the one or the other.", option);
        return o;
    }

    /// What draws belongs to the picture.
    static const MaterialsOptions& checked(const MaterialsOptions& o) {
        for (const char* option : {"--size", "--tier", "--shading"})
            if (o.output.empty() && o.given.contains(option))
                throw input_error("{}: the table has none; expected -o and the name of a picture beside it.", option);
        return o;
    }

    /// Shards share a run over every input, and a merged report measures nothing.
    static const ReportOptions& checked(const ReportOptions& o) {
        if (o.given.contains("--shard") && !o.full) throw input_error("--shard: shares a run over every input; expected --full beside it.");
        for (const char* option : {"--full", "--shard", "--only"})
            if (!o.merge.empty() && o.given.contains(option)) throw input_error("{}: nothing is measured; expected no --merge beside it.", option);
        return o;
    }

    /// The command that was given, or nullptr.
    const CLI::App* called() const {
        for (const CLI::App* app : {render_, compare_, bake_, info_, preview_, show_, materials_, gallery_, report_})
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
                               command == materials_ ? "options alone" : command == gallery_ ? "one directory" : command == report_ ? "bounds alone" : "one model",
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
             *show_ = nullptr, *materials_ = nullptr, *gallery_ = nullptr, *report_ = nullptr;
    RenderOptions render_options_{};
    CompareOptions compare_options_{};
    BakeOptions bake_options_{};
    InfoOptions info_options_{};
    PreviewOptions preview_options_{};
    ShowOptions show_options_{};
    MaterialsOptions materials_options_{};
    GalleryOptions gallery_options_{};
    ReportOptions report_options_{};
};

}  // namespace

Command parse_command_line(int argc, const char* const* argv) { return CommandLine().parse(argc, argv); }

}  // namespace shade16::host
