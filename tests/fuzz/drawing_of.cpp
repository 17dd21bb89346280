// The checks with one pipeline: the build says which.
#include <cstdio>
#include <cstdlib>

#include "host_sim/engine/runtime_renderer.hpp"
#include "tests/fuzz/drawing.hpp"
#include "tests/fuzz/guarded.hpp"

namespace shade16::fuzz {

namespace {

[[noreturn]] void fail(const Drawing& d, const char* complaint) {
    std::fprintf(stderr, "%s %s, %dx%d, bands of %d rows: %s.\n", targets[d.target].tier, targets[d.target].format, static_cast<int>(d.viewport.width),
                 static_cast<int>(d.viewport.height), static_cast<int>(d.band_rows), complaint);
    std::abort();
}

/// The last band first, each in memory of its own.
template <PixelFormat Format, class Renderer>
std::vector<typename Format::Pixel> drawn_in_bands(Renderer& renderer, const Drawing& d) {
    const auto stride = static_cast<std::size_t>(pixels_a_row<Format>(d.viewport.width)), width = static_cast<std::size_t>(d.viewport.width);
    std::vector<typename Format::Pixel> picture(stride * static_cast<std::size_t>(d.viewport.height));
    for (int32_t y = (d.viewport.height - 1) / d.band_rows * d.band_rows; y >= 0; y -= d.band_rows) {
        const int32_t rows = std::min(d.band_rows, d.viewport.height - y);
        Guarded<typename Format::Pixel> pixels(stride * static_cast<std::size_t>(rows), 2 * width);
        Guarded<uint16_t> depth(width * static_cast<std::size_t>(rows), 2 * width);
        renderer.draw(Band<Format>{pixels.begin(), depth.begin(), d.viewport.width, y, rows});
        if (!pixels.is_whole()) fail(d, "a band writes pixels beside its memory");
        if (!depth.is_whole()) fail(d, "a band writes depth beside its memory");
        std::copy_n(pixels.begin(), pixels.size(), picture.begin() + y * static_cast<std::ptrdiff_t>(stride));
    }
    return picture;
}

template <PixelFormat Format>
std::vector<typename Format::Pixel> background_of(const Drawing& d) {
    std::vector<typename Format::Pixel> picture(static_cast<std::size_t>(pixels_a_row<Format>(d.viewport.width) * d.viewport.height));
    clear_to(Band<Format>{picture.data(), nullptr, d.viewport.width, 0, d.viewport.height}, d.scene->background);
    return picture;
}

/// The second frame finds what the first has left behind, such as tables of light.
template <PixelFormat Format, class Renderer>
bool check_format(Renderer& renderer, const Drawing& d) {
    renderer.begin(*d.frame, d.viewport);
    const auto whole = renderer.template draw<Format>();
    renderer.begin(*d.frame, d.viewport);
    if (drawn_in_bands<Format>(renderer, d) != whole) fail(d, "the frame in bands is another than the whole one");
    return whole != background_of<Format>(d);
}

/// The formats of a pipeline, as `targets` has them.
template <PrecisionTier Tier, Channels Colors>
struct Formats;
template <PixelFormat Even, PixelFormat Odd>
struct Two {
    using even = Even;
    using odd = Odd;
};
template <> struct Formats<lowp, Channels::rgb> : Two<Rgb565, Rgb888> {};
template <> struct Formats<lowp, Channels::luma> : Two<Gray8, Dithered<Mono1, bayer8>> {};
template <> struct Formats<mediump, Channels::rgb> : Two<Rgb565, Rgb565Swapped> {};
template <> struct Formats<mediump, Channels::luma> : Two<Mono1, Gray4> {};
template <> struct Formats<highp, Channels::rgb> : Two<Rgb888, Dithered<Rgb565, bayer4>> {};
template <> struct Formats<highp, Channels::luma> : Two<Gray8, Dithered<Gray4, bayer8>> {};

}  // namespace

template <PrecisionTier Tier, Channels Colors>
bool check_drawing_of(const Drawing& d) {
    host::RuntimeRenderer<Tier, Colors> renderer(*d.scene);
    if (d.target % 2 == 0) return check_format<typename Formats<Tier, Colors>::even>(renderer, d);
    return check_format<typename Formats<Tier, Colors>::odd>(renderer, d);
}

template bool check_drawing_of<SHADE16_TIER, Channels::SHADE16_CHANNELS>(const Drawing&);

}  // namespace shade16::fuzz
