#include "host_sim/io/frame_writer.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/error.hpp"
#include "host_sim/io/atomic_file.hpp"

namespace shade16::host {

namespace {

std::string lower_case_ending(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

}  // namespace

int raw_bits_of(const std::string& ending) {
    return ending == ".rgb565" ? 16 : ending == ".gray8" ? 8 : ending == ".gray4" ? 4 : ending == ".mono1" ? 1 : 0;
}

std::unique_ptr<FrameWriter> open_writer(const std::string& path, int width, int height, int frame_count, int fps) {
    const std::string ending = lower_case_ending(path);
    if (is_standard_output(path) || ending == ".y4m") return open_y4m_writer(path, width, height, fps);
    if (ending == ".png") return open_png_writer(path, width, height, frame_count);
    if (ending == ".apng") return open_apng_writer(path, width, height, frame_count, fps);
    if (const int bits = raw_bits_of(ending); bits != 0) return open_raw_writer(path, width, height, bits);
    throw input_error(
        "{}: {} names no known format; expected .y4m, .apng, .png or a raw one (.rgb565, .gray8, .gray4, .mono1), or '-' for Y4M on standard output.", path,
        ending.empty() ? std::string("a name without an ending") : fmt::format("the ending '{}'", ending));
}

}  // namespace shade16::host
