// shade16: the host simulator.
#include <cstdio>
#include <new>

#include "host_sim/cli/bake.hpp"
#include "host_sim/cli/command_line.hpp"
#include "host_sim/cli/compare.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/cli/gallery.hpp"
#include "host_sim/cli/info.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/cli/materials.hpp"
#include "host_sim/cli/preview.hpp"
#include "host_sim/cli/render.hpp"
#include "host_sim/cli/report.hpp"
#include "host_sim/cli/show.hpp"
#include "host_sim/cli/signals.hpp"
#include "host_sim/io/atomic_file.hpp"

namespace shade16::host {
namespace {

struct Run {
    ExitCode operator()(const Answer& answer) const {
        print(answer.text);
        return ExitCode::ok;
    }
    ExitCode operator()(const RenderOptions& options) const { return render(options); }
    ExitCode operator()(const CompareOptions& options) const { return compare(options); }
    ExitCode operator()(const BakeOptions& options) const { return bake(options); }
    ExitCode operator()(const InfoOptions& options) const { return info(options); }
    ExitCode operator()(const PreviewOptions& options) const { return preview(options); }
    ExitCode operator()(const ShowOptions& options) const { return show(options); }
    ExitCode operator()(const MaterialsOptions& options) const { return materials(options); }
    ExitCode operator()(const GalleryOptions& options) const { return gallery(options); }
    ExitCode operator()(const ReportOptions& options) const { return report(options); }
};

ExitCode refuse(ExitCode code, const char* sentence) {
    std::fprintf(stderr, "%s %s\n", Ink(STDERR_FILENO).bad("shade16:").c_str(), sentence);
    return code;
}

ExitCode run(int argc, const char* const* argv) {
    try {
        return std::visit(Run{}, parse_command_line(argc, argv));
    } catch (const ClosedPipe&) {
        return ExitCode::ok;  // the reader has seen enough
    } catch (const Error& error) {
        return refuse(error.code, error.what());
    } catch (const std::bad_alloc&) {
        return refuse(ExitCode::io, "there is not enough memory for this.");
    }
}

}  // namespace
}  // namespace shade16::host

int main(int argc, char** argv) {
    shade16::host::handle_signals();
    return static_cast<int>(shade16::host::run(argc, argv));
}
