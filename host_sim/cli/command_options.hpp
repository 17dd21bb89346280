// What each command takes: its arguments and options, with the line of help that each has.
#pragma once

#include "host_sim/cli/options.hpp"

namespace CLI {
class App;
}

namespace shade16::host {

void add_render(CLI::App& app, RenderOptions& o);
void add_compare(CLI::App& app, CompareOptions& o);
void add_bake(CLI::App& app, BakeOptions& o);
void add_info(CLI::App& app, InfoOptions& o);
void add_show(CLI::App& app, ShowOptions& options);
void add_preview(CLI::App& app, PreviewOptions& o);
void add_materials(CLI::App& app, MaterialsOptions& o);
void add_gallery(CLI::App& app, GalleryOptions& o);
void add_report(CLI::App& app, ReportOptions& o);

}  // namespace shade16::host
