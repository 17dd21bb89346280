#include "host_sim/cli/report.hpp"

#include <filesystem>

#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/page.hpp"
#include "host_sim/cli/bounds_json.hpp"
#include "host_sim/cli/console.hpp"
#include "host_sim/cli/ink.hpp"
#include "host_sim/io/atomic_file.hpp"

namespace shade16::host {

namespace {

/// One line an entry, as soon as it is measured: of a long run it is the progress, and its log.
void print_result(const bounds::Result& r) {
    const std::string share = r.bound == 0 ? "" : fmt::format(" ({:.1f} %)", 100 * r.measured / r.bound);
    const std::string verdict = r.holds() ? "" : Ink(STDOUT_FILENO).bad(" BROKEN");
    print(fmt::format("{:<44} {:>10} of {:<10} {}{}; {} {}{}\n", bounds::label(r.name, r.tier),
                      bounds::figure(r.measured), bounds::figure(r.bound), r.unit, share, bounds::with_commas(r.inputs),
                      r.is_exhaustive() ? "inputs, which are all" : "inputs", verdict));
}

class Measuring {
public:
    explicit Measuring(const ReportOptions& o) : options_(o) {
        const bounds::Entries all = bounds::functions();
        for (const bounds::Entry& entry : all.all())
            if (bounds::label(entry.name, entry.tier).starts_with(o.only)) entries_.push_back(entry);
        for (const bounds::Entry& entry : entries_)
            spans_.push_back(o.full ? bounds::all_spans(entry, o.shard) : bounds::ordinary_spans(entry));
        for (const auto& spans : spans_) total_ += spans.size();
    }

    std::vector<bounds::Result> functions() const {
        Progress progress("measuring", static_cast<int>(total_), options_.quiet);
        std::vector<bounds::Result> results;
        std::size_t begun = 0;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const bounds::Peak peak = bounds::measure(
                entries_[i], spans_[i], [&](std::size_t done) { progress.begin(static_cast<int>(begun + done) - 1); });
            begun += spans_[i].size();
            results.push_back(bounds::result_of(entries_[i], peak));
            say(results.back());
        }
        return results;
    }

    /// Ten times as long in a full run, of which every shard searches elsewhere.
    std::vector<bounds::VertexResult> vertices() const {
        return bounds::search_all(options_.only, options_.full ? 10 : 1, options_.shard.number * 1000,
                                  [this](const bounds::VertexResult& v) { say(v.result()); });
    }

private:
    void say(const bounds::Result& result) const {
        if (!options_.quiet && !options_.json) print_result(result);
    }

    const ReportOptions& options_;
    std::vector<bounds::Entry> entries_{};
    std::vector<std::vector<bounds::Span>> spans_{};
    std::size_t total_ = 0;
};

std::vector<bounds::Result> merged(const std::vector<std::string>& files) {
    std::vector<bounds::Result> results = read_bounds_json(files.front());
    for (std::size_t i = 1; i < files.size(); ++i) bounds::merge(results, read_bounds_json(files[i]), files[i]);
    return results;
}

void refuse_broken(const std::vector<bounds::Result>& results) {
    std::string names;
    for (const bounds::Result& r : results)
        if (!r.holds())
            names += (names.empty() ? "" : "; ") +
                     fmt::format("{} is off {} {}, expected at most {}", bounds::label(r.name, r.tier),
                                 bounds::figure(r.measured), r.unit, bounds::figure(r.bound));
    if (!names.empty()) throw Error(ExitCode::check, "bounds are broken: " + names + ".");
}

}  // namespace

ExitCode report(const ReportOptions& o) {
    std::error_code failed;
    std::filesystem::create_directories(o.output, failed);
    if (!std::filesystem::is_directory(o.output))
        throw input_error("--output {}: is no directory, and none can be made there.", o.output);
    const std::filesystem::path directory = o.output;

    bounds::Report report;
    if (o.merge.empty()) {
        const Measuring measuring(o);
        report.results = measuring.functions();
        report.vertices = measuring.vertices();
        for (const bounds::VertexResult& v : report.vertices) report.results.push_back(v.result());
    } else {
        report.results = merged(o.merge);
        if (!o.quiet && !o.json)
            for (const bounds::Result& r : report.results) print_result(r);
    }
    if (report.results.empty())
        throw input_error("--only {}: no bound has a name that begins so; 'shade16 report bounds' prints all of them.",
                          o.only);
    const std::string json = bounds_json(report.results);
    write_file(directory / "bounds.json", json);
    write_file(directory / "bounds.html", bounds::page(report));
    write_file(directory / "bounds.md", bounds::markdown(report));
    if (o.json) print(json);
    refuse_broken(report.results);
    return ExitCode::ok;
}

}  // namespace shade16::host
