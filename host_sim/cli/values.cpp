#include "host_sim/cli/values.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "host_sim/cli/usage.hpp"
#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"
#include "host_sim/io/frame_writer.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

namespace {

/// The whole word as a number, digits alone; nothing else, and nothing that does not fit.
std::optional<int> number(std::string_view word) {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// A name such as `.png` is no ending, but a file's whole name.
bool has_ending(const std::string& path, std::string_view ending) {
    const std::string own = std::filesystem::path(path).extension().string();
    return std::ranges::equal(own, ending, [](char a, char b) { return ('A' <= a && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

}  // namespace

int whole_number(std::string_view option, const std::string& word, int least, int largest) {
    const std::optional<int> value = number(word);
    if (!value || *value < least || *value > largest)
        throw input_error("{} {}: expected a whole number from {} to {}.", option, word, least, largest);
    return *value;
}

Viewport size_of(const std::string& word) {
    const std::size_t cross = std::min(word.find('x'), word.size());
    const std::optional<int> width = number(std::string_view(word).substr(0, cross));
    const std::optional<int> height = number(std::string_view(word).substr(std::min(cross + 1, word.size())));
    const auto is_target = [](std::optional<int> pixels) { return pixels && *pixels >= 1 && *pixels <= max_target_px; };
    if (!is_target(width) || !is_target(height))
        throw input_error("--size {}: expected WIDTHxHEIGHT, each from 1 to {} pixels, such as 320x240.", word,
                          max_target_px);
    return {*width, *height};
}

Shading shading_of(const std::string& word) {
    expect_one_of("--shading", word, {"flat", "gouraud", "phong"});
    return word == "flat" ? Shading::flat : word == "phong" ? Shading::phong : Shading::gouraud;
}

NormalPath normals_of(const std::string& word) {
    expect_one_of("--normals", word, {"linear", "spherical"});
    return word == "spherical" ? NormalPath::spherical : NormalPath::linear;
}

Reflection reflection_of(const std::string& word) {
    expect_one_of("--reflection", word, {"blinn_phong", "phong"});
    return word == "phong" ? Reflection::phong : Reflection::blinn_phong;
}

LightTable light_table_of(const std::string& word) {
    expect_one_of("--light-table", word, {"none", "nearest", "bilinear"});
    return word == "nearest" ? LightTable::nearest : word == "bilinear" ? LightTable::bilinear : LightTable::none;
}

Filter filter_of(const std::string& word) {
    expect_one_of("--filter", word, {"nearest", "bilinear"});
    return word == "bilinear" ? Filter::bilinear : Filter::nearest;
}

Mapping mapping_of(const std::string& word) {
    expect_one_of("--mapping", word, {"affine", "perspective"});
    return word == "perspective" ? Mapping::perspective : Mapping::affine;
}

Component component_of(const std::string& word) {
    expect_one_of("--component", word, {"all", "ambient", "diffuse", "specular"});
    return word == "ambient"    ? Component::ambient
           : word == "diffuse"  ? Component::diffuse
           : word == "specular" ? Component::specular
                                : Component::all;
}

double crease_of(const std::string& word) {
    double degrees = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), degrees);
    if (error != std::errc{} || end != word.data() + word.size() || !(degrees >= 0 && degrees <= 180))
        throw input_error("--crease {}: expected an angle from 0 to 180 degrees, such as 60.", word);
    return degrees;
}

Engine engine_of(const std::string& word) {
    expect_one_of("--engine", word, {"fixed", "reference"});
    return word == "fixed" ? Engine::fixed : Engine::reference;
}

std::string tier_of(const std::string& word) {
    expect_one_of("--tier", word, {lowp::name, mediump::name, highp::name});
    return word;
}

std::string format_of(const std::string& word) {
    expect_one_of("--format", word, format_names);
    return word;
}

std::string dither_of(const std::string& word) {
    expect_one_of("--dither", word, dither_names);
    return word;
}

ScreenKind screen_kind_of(const std::string& word) {
    expect_one_of("--board", word, {"linux_spi", "fbdev", "terminal"});
    return word == "fbdev" ? ScreenKind::fbdev : word == "terminal" ? ScreenKind::terminal : ScreenKind::linux_spi;
}

int quarter_turns_of(const std::string& word) {
    expect_one_of("--rotate", word, {"0", "90", "180", "270"});
    return *number(word) / 90;
}

uint8_t spi_mode_of(const std::string& word) {
    if (word != "0" && word != "3") throw input_error("--spi-mode {}: expected 0 or 3.", word);
    return word == "3" ? 3 : 0;
}

uint32_t hz_of(const std::string& word) {
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [after, error] = std::from_chars(word.data(), end, value);
    std::string unit(after, end);
    if (unit.ends_with("Hz")) unit.resize(unit.size() - 2);
    const double factor = unit.empty() ? 1 : unit == "k" ? 1e3 : unit == "M" ? 1e6 : 0;
    const double hz = error == std::errc{} ? value * factor : 0;
    if (!(hz >= 1000 && hz <= 500e6)) throw input_error("--spi-hz {}: expected a clock from 1k to 500M, such as 32M.", word);
    return static_cast<uint32_t>(hz);
}

std::string subject_of(const std::string& word) {
    expect_one_of("report", word, {"bounds"});
    return word;
}

bounds::Shard shard_of(const std::string& word) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::optional<int> share = number(std::string_view(word).substr(0, slash)), of = number(std::string_view(word).substr(std::min(slash + 1, word.size())));
    if (!share || !of || *of < 1 || *share < 0 || *share >= *of) throw input_error("--shard {}: expected I/N, a share from 0 to N - 1, such as 0/2.", word);
    return {static_cast<uint64_t>(*share), static_cast<uint64_t>(*of)};
}

std::string picture_of(const std::string& path) {
    if (!has_ending(path, ".png"))
        throw input_error("--output {}: is no name of a picture; expected one that ends in .png.", path);
    return path;
}

OutputKind kind_of(const std::string& path) {
    if (path.empty()) throw input_error("--output: the name is empty; expected one such as frame.png.");
    if (is_standard_output(path) || has_ending(path, ".y4m")) return OutputKind::y4m;
    if (has_ending(path, ".apng")) return OutputKind::apng;
    if (has_ending(path, ".png")) return OutputKind::png;
    for (const char* ending : {".rgb565", ".gray8", ".gray4", ".mono1"})
        if (has_ending(path, ending)) return OutputKind::raw;
    open_writer(path, 1, 1, 1, 1);  // knows how to refuse it
    throw std::logic_error("every output that can be opened has a kind");
}

}  // namespace shade16::host
