// A framebuffer that watches the raster stage: it counts what is written to each pixel, keeps colours as they were before
// rounding, has guard words around its memory, and prints itself as ASCII art.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "shade16/pipeline/raster.hpp"

namespace shade16::test {

/// Colour codes before the rounding that drops the fraction: half a code more than the colour.
struct Codes {
    double r = 0, g = 0, b = 0;
};

/// The raster stage writes `*pixel = value`: so an assignment is a write.
struct CountedPixel {
    Codes codes{};
    int writes = 0;

    CountedPixel() = default;
    explicit CountedPixel(Codes c) : codes(c) {}
    CountedPixel(const CountedPixel&) = default;
    CountedPixel& operator=(const CountedPixel& other) {
        codes = other.codes;
        ++writes;
        return *this;
    }
};

/// A format of any depth whose pixels keep the fractions of exact stepping.
template <int Red, int Green, int Blue>
struct CountedFormat {
    using Pixel = CountedPixel;
    static constexpr int red_bits = Red, green_bits = Green, blue_bits = Blue;
    static Pixel pack(uint32_t r, uint32_t g, uint32_t b) { return Pixel{{r + 0.5, g + 0.5, b + 0.5}}; }
    static Pixel from_q24(uint32_t r, uint32_t g, uint32_t b) {
        constexpr double q24 = 1.0 / (1 << 24);
        return Pixel{{r * q24, g * q24, b * q24}};
    }
};
using Counted888 = CountedFormat<8, 8, 8>;

/// The same for packed words: [green 6.5 | red 5.5, 0 | blue 5.5].
struct Counted565 : CountedFormat<5, 6, 5> {
    static Pixel from_word(uint32_t word) { return Pixel{{(word >> 11 & 0x3FF) / 32.0, (word >> 21) / 32.0, (word & 0x3FF) / 32.0}}; }
};

/// A point in 1/16 pixel from the frame's top left.
struct Point {
    int32_t x = 0, y = 0;
    friend bool operator==(Point, Point) = default;
};

template <class Format, bool Depth = false>
class MockFramebuffer {
public:
    MockFramebuffer(int32_t frame_width, int32_t frame_height, int32_t first_row, int32_t rows)
        : width(frame_width), height(frame_height), first_row_(first_row), rows_(rows),
          guard_(static_cast<size_t>(2 * frame_width + 64)), pixels_(count() + 2 * guard_), depth_(count() + 2 * guard_, far_depth) {}
    MockFramebuffer(int32_t frame_width, int32_t frame_height) : MockFramebuffer(frame_width, frame_height, 0, frame_height) {}

    const int32_t width, height;

    Band<Format> band() { return {pixels_.data() + guard_, Depth ? depth_.data() + guard_ : nullptr, width, first_row_, rows_}; }
    RasterPoint centre() const { return {width * 8, height * 8}; }

    /// A vertex at a point in 1/16 pixel from the frame's top left.
    template <class Tier>
    ScreenVertex<Tier> vertex(Point p) const {
        ScreenVertex<Tier> v;
        v.x = static_cast<int16_t>(p.x - centre().x), v.y = static_cast<int16_t>(p.y - centre().y);
        return v;
    }

    /// Draws a triangle as the pipeline does. Both ways round, because the raster stage itself knows no back faces.
    template <Stepping Step, class Tier>
    void draw(const ScreenVertex<Tier>& a, const ScreenVertex<Tier>& b, const ScreenVertex<Tier>& c) {
        const int64_t area = doubled_area(a, b, c);
        if (area > 0) return draw<Step>(a, c, b);
        const FacingTriangle<Tier> triangle(a, b, c, centre(), first_row_, rows_);
        if (area < 0 && triangle.shows(width)) draw_triangle<Step, Depth>(triangle, band());
    }

    const CountedPixel& at(int32_t x, int32_t y) const { return pixels_[index(x, y)]; }
    uint16_t depth_at(int32_t x, int32_t y) const { return depth_[index(x, y)]; }

    void reset() {
        for (size_t i = guard_; i < guard_ + count(); ++i) pixels_[i].writes = 0;
        for (size_t i = guard_; i < guard_ + count(); ++i) depth_[i] = far_depth;
    }

    /// Compares each pixel's number of writes with what it should be; the guards must not have been written at all.
    template <class Expected>
    ::testing::AssertionResult is_written(Expected expected) const {
        for (int32_t y = first_row_; y < first_row_ + rows_; ++y)
            for (int32_t x = 0; x < width; ++x)
                if (const int want = expected(x, y), got = at(x, y).writes; want != got)
                    return ::testing::AssertionFailure() << (got > want ? want == 0 ? "drawn outside" : "overdrawn" : "a gap") << " at column " << x << ", row " << y
                                                         << ": written " << got << " times, not " << want << '\n' << art();
        return guards_are_untouched();
    }
    ::testing::AssertionResult guards_are_untouched() const {
        for (size_t i = 0; i < guard_; ++i)
            if (pixels_[i].writes + pixels_[pixels_.size() - 1 - i].writes != 0 || depth_[i] != far_depth || depth_[depth_.size() - 1 - i] != far_depth)
                return ::testing::AssertionFailure() << "written outside of the band";
        return ::testing::AssertionSuccess();
    }

    /// '.' for an empty pixel, '#' for one drawn once, the number of writes where there are more.
    std::string art() const {
        std::string picture = "\n";
        for (int32_t y = first_row_; y < first_row_ + rows_; ++y) {
            for (int32_t x = 0; x < width && x < 200; ++x) {
                const int writes = at(x, y).writes;
                picture += writes == 0 ? '.' : writes == 1 ? '#' : static_cast<char>('0' + (writes < 9 ? writes : 9));
            }
            picture += '\n';
        }
        return picture;
    }

private:
    size_t count() const { return static_cast<size_t>(width) * static_cast<size_t>(rows_); }
    size_t index(int32_t x, int32_t y) const { return guard_ + static_cast<size_t>((y - first_row_) * width + x); }

    int32_t first_row_, rows_;
    size_t guard_;
    std::vector<CountedPixel> pixels_;
    std::vector<uint16_t> depth_;
};

/// A triangle by 64-bit edge functions and the top-left rule: what the raster stage must equal.
class ExactTriangle {
public:
    ExactTriangle(Point a, Point b, Point c) : corner_{a, b, c} {
        if (area() < 0) corner_[1] = c, corner_[2] = b;
    }
    int64_t area() const { return edge(0, corner_[2]); }

    /// Whether a pixel's centre is inside.
    bool covers(int32_t x, int32_t y) const {
        if (area() == 0) return false;
        for (int i = 0; i < 3; ++i) {
            const int64_t e = edge(i, {x * 16 + 8, y * 16 + 8});
            if (e < 0 || (e == 0 && !is_top_or_left(i))) return false;
        }
        return true;
    }

private:
    /// Positive inside: the corners run clockwise on the screen, where y points down.
    int64_t edge(int i, Point p) const {
        const Point a = corner_[i], b = corner_[(i + 1) % 3];
        return int64_t{b.x - a.x} * (p.y - a.y) - int64_t{b.y - a.y} * (p.x - a.x);
    }
    bool is_top_or_left(int i) const {
        const Point a = corner_[i], b = corner_[(i + 1) % 3];
        return b.y < a.y || (b.y == a.y && b.x > a.x);  // upwards, or to the right along the top
    }

    Point corner_[3];
};

/// An attribute of three corners at a pixel's centre, before any rounding.
inline double interpolate_exactly(const Point (&p)[3], const double (&value)[3], int32_t x, int32_t y) {
    const int64_t px = x * 16 + 8 - p[0].x, py = y * 16 + 8 - p[0].y;
    const int64_t ax = p[1].x - p[0].x, ay = p[1].y - p[0].y, bx = p[2].x - p[0].x, by = p[2].y - p[0].y;
    const int64_t area = ax * by - bx * ay, u = px * by - bx * py, v = ax * py - px * ay;  // all below 2^35: exact
    return value[0] + ((value[1] - value[0]) * static_cast<double>(u) + (value[2] - value[0]) * static_cast<double>(v)) / static_cast<double>(area);
}

}  // namespace shade16::test
