// Random frames of random scenes, as many as one wants: random_frames [--frames N] [--shard I/N] [--seed S] [--only FRAME]
// Each frame has bytes of its own, so that a fault is found again by its number alone. Shards are shares of the same frames.
#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string_view>

#include <sanitizer/common_interface_defs.h>

#include "host_sim/report/terms.hpp"
#include "tests/fuzz/byte_scene.hpp"

namespace shade16::fuzz {
namespace {

constexpr std::size_t bytes_a_frame = 1024;

struct Options {
    uint64_t frames = 100'000, shard = 0, shards = 1, seed = 1;
    std::optional<uint64_t> only{};
};

struct Summary {
    uint64_t frames = 0, shown = 0;
    Needs needs{};
    std::array<uint64_t, target_count> of_target{};

    /// Whether the frames mean something: every term and target was among them, and half of them show some of it.
    bool means_something() const {
        bool every_target = true;
        for (const uint64_t count : of_target) every_target = every_target && count > 0;
        return needs == all_needs && every_target && 2 * shown >= frames;
    }
    void print_what_is_missing() const {
        for (std::size_t i = 0; i < of_target.size(); ++i)
            if (of_target[i] == 0) std::printf("No frame was for %s %s.\n", targets[i].tier, targets[i].format);
        for (const host::Term& term : host::terms)
            if (!(needs.*term.is_needed)) std::printf("No frame needed the term %s.\n", term.name);
    }
};

uint64_t frame_at_hand = 0;
void say_which_frame() { std::fprintf(stderr, "This was frame %llu: see it alone by --only.\n", static_cast<unsigned long long>(frame_at_hand)); }

void draw(uint64_t seed, uint64_t number, Summary& summary) {
    std::mt19937_64 random(seed * 1'000'000'007 + number);
    std::array<uint8_t, bytes_a_frame> bytes{};
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random() >> 56);
    const ByteScene scene(Bytes(bytes.data(), bytes.size()));
    summary.shown += check_drawing(scene.drawing());
    ++summary.frames, ++summary.of_target[scene.drawing().target];
    summary.needs = summary.needs | needs_of(*scene.drawing().scene);
}

[[noreturn]] void refuse_command_line() {
    std::fprintf(stderr, "usage: random_frames [--frames N] [--shard I/N, I from 0 to N - 1] [--seed S] [--only FRAME]\n");
    std::exit(2);
}

uint64_t number(std::string_view text) {
    uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) refuse_command_line();
    return value;
}

void read_option(std::string_view name, std::string_view value, Options& o) {
    const std::size_t slash = std::min(value.find('/'), value.size());
    if (name == "--frames") o.frames = number(value);
    else if (name == "--seed") o.seed = number(value);
    else if (name == "--only") o.only = number(value);
    else if (name == "--shard" && slash < value.size()) o.shard = number(value.substr(0, slash)), o.shards = number(value.substr(slash + 1));
    else refuse_command_line();
}

Options options_of(int argc, char** argv) {
    Options o;
    for (int i = 1; i < argc; i += 2) read_option(argv[i], i + 1 < argc ? argv[i + 1] : "", o);
    if (o.shard >= o.shards) refuse_command_line();
    return o;
}

int run(const Options& o) {
    Summary summary;
    const uint64_t first = o.only.value_or(o.shard), end = o.only ? first + 1 : o.frames;
    for (uint64_t i = first; i < end; i += o.shards) {
        frame_at_hand = i;
        draw(o.seed, i, summary);
        if (summary.frames % 10'000 == 0) std::printf("%llu frames\n", static_cast<unsigned long long>(summary.frames)), std::fflush(stdout);
    }
    std::printf("%llu random frames, %llu of them not empty.\n", static_cast<unsigned long long>(summary.frames), static_cast<unsigned long long>(summary.shown));
    if (o.only || summary.means_something()) return 0;
    summary.print_what_is_missing();
    std::printf("That is no test of everything: there must be more frames, or others.\n");
    return 1;
}

}  // namespace
}  // namespace shade16::fuzz

int main(int argc, char** argv) {
    __sanitizer_set_death_callback(shade16::fuzz::say_which_frame);
    std::signal(SIGABRT, [](int) { shade16::fuzz::say_which_frame(); });  // of a check that fails
    return shade16::fuzz::run(shade16::fuzz::options_of(argc, argv));
}
