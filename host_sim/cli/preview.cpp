#include "host_sim/cli/preview.hpp"

#include "host_sim/cli/show.hpp"

namespace shade16::host {

ExitCode preview(const PreviewOptions& o) {
    ShowOptions show_options{.scene = o};
    show_options.screen.kind = ScreenKind::terminal;
    show_options.quiet = true;
    return show(show_options);
}

}  // namespace shade16::host
