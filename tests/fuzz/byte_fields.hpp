// ByteFields: the fields of a scene from bytes. Most scenes are made of usual values, so that something shows; in the others some
// fields, and in a few many, are extreme: ends of ranges, zeros, or any bits at all.
#pragma once

#include "shade16/shade16.hpp"
#include "tests/fuzz/bytes.hpp"

namespace shade16::fuzz {

class ByteFields {
public:
    explicit ByteFields(Bytes bytes) : bytes_(bytes) {
        const uint32_t wild = bytes_.u8();
        extreme_of_256_ = wild < 128 ? 0 : wild < 224 ? 4 : wild < 248 ? 16 : 64;
    }

    uint32_t below(uint32_t n) { return bytes_.below(n); }
    bool one_in(uint32_t n) { return bytes_.one_in(n); }
    uint16_t u16() { return bytes_.u16(); }
    int8_t i8() { return static_cast<int8_t>(bytes_.u8()); }
    int16_t i16() { return static_cast<int16_t>(bytes_.u16()); }
    template <class Enum>
    Enum one_of(uint32_t count) {
        return static_cast<Enum>(bytes_.below(count));
    }

    /// Whether the field at hand is an extreme one.
    bool is_extreme() { return extreme_of_256_ != 0 && bytes_.u8() >= 256 - extreme_of_256_; }

    /// Usually from `low` to `high`, in 1/1000.
    Q16 q16(int32_t low, int32_t high) {
        if (is_extreme()) return Q16::from_raw(extreme());
        return Q16::from_raw(static_cast<int32_t>((int64_t{low} * 65536 + (int64_t{high} - low) * bytes_.u16()) / 1000));
    }
    Vec3 vec3(int32_t low, int32_t high) {
        const Q16 x = q16(low, high), y = q16(low, high), z = q16(low, high);
        return {x, y, z};
    }
    /// Usually up to a quarter turn.
    Angle angle() { return {is_extreme() ? static_cast<uint32_t>(extreme()) : uint32_t{bytes_.u16()} << 14}; }
    Angle any_turn() { return {uint32_t{bytes_.u16()} << 16}; }

    Rgb color() {
        const uint32_t kind = bytes_.below(8);
        if (kind == 6) return white;
        if (kind == 7) return black;
        const auto channel = [this] { return Unorm16::from_raw(bytes_.u16()); };
        const Unorm16 r = channel(), g = channel(), b = channel();
        return {r, g, b};
    }
    Scaled intensity() {
        if (is_extreme()) {
            const uint32_t mantissa = bytes_.u32();
            return {mantissa, i16()};
        }
        return Scaled::normalized(bytes_.u16(), -15);
    }
    Mat3 rotation() {
        const Angle x = any_turn(), y = any_turn(), z = any_turn();
        Mat3 m = rotate_x(x) * rotate_y(y) * rotate_z(z);
        for (Normal30& row : m.row)
            for (Q30* component : {&row.x, &row.y, &row.z})
                if (is_extreme()) *component = Q30::from_raw(extreme());
        return m;
    }

private:
    int32_t extreme() {
        constexpr int32_t ends[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, 0, 1, -1, 16384 * 65536, -16384 * 65536, 65536, -65536};
        constexpr uint32_t count = sizeof(ends) / sizeof(ends[0]);
        const uint32_t kind = bytes_.below(2 * count);
        return kind < count ? ends[kind] : static_cast<int32_t>(bytes_.u32());
    }

    Bytes bytes_;
    uint32_t extreme_of_256_ = 0;
};

}  // namespace shade16::fuzz
