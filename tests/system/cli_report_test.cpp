// The report of the bounds as its users run it: a page, JSON and tables; shards that merge; and what is refused.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/system/program.hpp"

namespace shade16::host {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

json entries(const ScratchDirectory& scratch, const std::string& name) {
    return json::parse(scratch.read(name)).at("bounds");
}

TEST(CliReport, leaves_a_page_that_needs_nothing_beside_it_json_and_tables) {
    const ScratchDirectory scratch;
    const Ran ran = shade16_program("report bounds --only 'table of 49' -o " + scratch.path("new/place"));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("table of 49 for rsqrt"), HasSubstr("of 0.501"),
                               HasSubstr("49 inputs, which are all")));
    const std::string page = scratch.read("new/place/bounds.html");
    EXPECT_THAT(page, AllOf(HasSubstr("<!doctype html>"), HasSubstr("All 1 bounds are kept."), HasSubstr("</html>")));
    for (const char* elsewhere : {"<script", "src=", "href="})
        EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
    EXPECT_THAT(scratch.read("new/place/bounds.md"), HasSubstr("| table of 49 for rsqrt |"));
    const json only = entries(scratch, "new/place/bounds.json").at(0);
    for (const char* key : {"name", "tier", "unit", "bound", "measured", "inputs"})
        EXPECT_TRUE(only.contains(key)) << key;
    EXPECT_EQ(only.at("inputs"), 49);
}

TEST(CliReport, takes_a_single_one_by_what_it_prints) {
    const ScratchDirectory scratch;
    for (const char* label : {"vertex: range, highp", "shininess never rises, lowp"}) {
        const Ran ran = shade16_program("report bounds --only '" + std::string(label) + "' -o " + scratch.path(""));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_THAT(ran.out, testing::StartsWith(label));
        EXPECT_EQ(entries(scratch, "bounds.json").size(), 1u) << label;
    }
}

TEST(CliReport, shards_merge_to_what_one_machine_measures) {
    const ScratchDirectory scratch;
    const auto run = [&](const std::string& options) {
        const Ran ran = shade16_program("report bounds --only 'shininess never rises' --quiet " + options);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
    };
    run("--full -o " + scratch.path("whole"));
    for (const char* shard : {"0", "1", "2"})
        run(std::string("--full --shard ") + shard + "/3 -o " + scratch.path(shard));
    const Ran merged =
        shade16_program("report bounds -o " + scratch.path("merged") + " --merge " + scratch.path("0/bounds.json") +
                        " " + scratch.path("1/bounds.json") + " " + scratch.path("2/bounds.json"));
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("shininess never rises, highp"));
    EXPECT_EQ(entries(scratch, "merged/bounds.json"), entries(scratch, "whole/bounds.json"));
}

TEST(CliReport, a_broken_bound_is_an_exit_code_and_a_sentence) {
    const ScratchDirectory scratch;
    shade16_program("report bounds --quiet --only 'table of 49' -o " + scratch.path(""));
    json report = json::parse(scratch.read("bounds.json"));
    report["bounds"][0]["measured"] = 0.6;
    scratch.write("broken.json", report.dump());
    const Ran ran = shade16_program("report bounds -o " + scratch.path("") + " --merge " + scratch.path("broken.json"));
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.err,
                HasSubstr("bounds are broken: table of 49 for rsqrt is off 0.6 units, expected at most 0.501."));
    EXPECT_THAT(scratch.read("bounds.html"), HasSubstr("1 of 1 bounds are broken."));
}

TEST(CliReport, what_makes_no_sense_is_refused_in_a_sentence) {
    const ScratchDirectory scratch;
    const auto refused = [&](const std::string& arguments, int code, const std::string& sentence) {
        const Ran ran = shade16_program("report " + arguments);
        EXPECT_EQ(ran.exit_code, code) << arguments;
        EXPECT_THAT(ran.err, HasSubstr(sentence));
        EXPECT_THAT(ran.out, IsEmpty());
    };
    const std::string out = " -o " + scratch.path("out");
    refused(out, 2, "what the report is about is missing: expected bounds");
    refused("bounds", 2, "the name of the output is missing");
    refused("pounds" + out, 2, "report pounds: expected bounds; did you mean bounds?");
    refused("bounds --shard 0/2" + out, 2, "--shard: shares a run over every input; expected --full beside it.");
    refused("bounds --full --shard 2/2" + out, 2, "--shard 2/2: expected I/N, a share from 0 to N - 1, such as 0/2.");
    refused("bounds --only nothing" + out, 2, "--only nothing: no bound has a name that begins so");
    refused("bounds --full --merge x.json" + out, 2, "--full: nothing is measured; expected no --merge beside it.");
    refused("bounds --merge " + scratch.path("gone.json") + out, 3,
            "gone.json: cannot be opened; expected a bounds.json that 'shade16 report bounds' wrote.");
    refused("bounds --merge " + scratch.write("text.json", "no") + out, 2,
            "text.json: is no bounds.json; expected one that 'shade16 report bounds' wrote.");
    refused("bounds -o " + scratch.write("file", "") + "/below", 2, "is no directory, and none can be made there.");
}

}  // namespace
}  // namespace shade16::host
