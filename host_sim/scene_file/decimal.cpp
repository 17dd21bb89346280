#include "host_sim/scene_file/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace shade16::host {

namespace {

constexpr int most_decimals = 9;  // what the core's literals look at
constexpr double degrees_a_turn = 360;

/// Shortest first; `reads_back` says whether a number is the wanted one.
template <class ReadsBack>
std::string shortest(double value, ReadsBack reads_back) {
    for (int decimals = 0; decimals < most_decimals; ++decimals) {
        const std::string text = fmt::format("{:.{}f}", value, decimals);
        if (reads_back(std::stod(text))) return text == "-0" ? "0" : text;
    }
    return fmt::format("{:.{}f}", value, most_decimals);
}

}  // namespace

int64_t times(double value, uint64_t scale) {
    std::array<char, 512> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::fabs(value), std::chars_format::fixed);
    uint64_t whole = 0, fraction = 0, unit = 1;
    bool after_point = false;
    for (const char* c = text.data(); c != end.ptr; ++c) {
        if (*c == '.') {
            after_point = true;
        } else if (!after_point) {
            whole = whole * 10 + static_cast<uint64_t>(*c - '0');
        } else if (unit < 1'000'000'000) {
            fraction = fraction * 10 + static_cast<uint64_t>(*c - '0');
            unit *= 10;
        }
    }
    const auto magnitude = static_cast<int64_t>(whole * scale + (fraction * scale + unit / 2) / unit);
    return value < 0 ? -magnitude : magnitude;
}

Angle degrees_of(double value) {
    // Whole turns go first: the core's literal takes one at most.
    const auto scaled = static_cast<uint64_t>(times(std::fmod(std::fabs(value), degrees_a_turn), uint64_t{1} << 32));
    const Angle angle{static_cast<uint32_t>((scaled + 180) / 360)};
    return value < 0 ? -angle : angle;
}

std::string decimal(Q16 value) {
    return shortest(value.raw / 65536.0, [&](double v) { return q16_of(v) == value; });
}

std::string decimal(Unorm16 value) {
    return shortest(double(value.raw) / Unorm16::one, [&](double v) { return unorm_of(v) == value; });
}

std::string decimal(Scaled value) {
    return shortest(std::ldexp(value.mantissa, value.exponent - 32), [&](double v) { return scaled_of(v) == value; });
}

std::string decimal(Q30 value) {
    return shortest(std::ldexp(value.raw, -Q30::fraction_bits), [&](double v) { return q30_of(v) == value; });
}

std::string decimal_degrees(Angle value) {
    return shortest(std::ldexp(value.turns, -32) * degrees_a_turn, [&](double v) { return degrees_of(v) == value; });
}

std::string decimal(double value) {
    return shortest(value, [&](double v) { return times(v, uint64_t{1} << 32) == times(value, uint64_t{1} << 32); });
}

}  // namespace shade16::host
