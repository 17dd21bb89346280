// Pixels by the normal-to-colour table: a place in the table is interpolated, and its entry shown.
#pragma once

#include "shade16/pipeline/light_table.hpp"
#include "shade16/pipeline/paint_samples.hpp"
#include "shade16/pipeline/texture_lookup.hpp"

namespace shade16 {

/// A pixel's place in the table, in 2^-21 entry.
struct TableSample {
    int32_t s = 0, t = 0;
};
struct TableKind {
    using Sample = TableSample;
    static constexpr bool by_depth = false;
    template <class F, class... S>
    SHADE16_INLINE static constexpr void for_each_number(F f, S&... s) {
        f(s.s...), f(s.t...);
    }
};

template <PrecisionTier Tier>
constexpr TableSample table_sample(const LightTableMemory<Tier>& table, const UnitVector<Tier>& normal) {
    constexpr int32_t widen = Arithmetic<Tier>::wide ? 1 : 65536;
    const IVec3 n = raw(normal);
    const IVec3 v = rotate(table.to_view, {n.x * widen, n.y * widen, n.z * widen});
    const TablePlace place = detail::table_place({{v.x}, {v.y}, {v.z}});
    return {int32_t{place.s} * 2048, int32_t{place.t} * 2048};
}

/// What looks a pixel's colour up.
template <Needs N, Channels C>
struct TableLight {
    using Kind = TableKind;

    const uint16_t* entry;
    bool bilinear;

    template <PixelFormat Format>
    [[gnu::noinline]] constexpr typename Format::Pixel pixel(const TableSample& s) const {
        return detail::pixel_of_light<Format>(light(s));
    }
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr ByChannel<C, uint32_t> codes(const TableSample& s) const {
        return detail::codes_of_light<Format>(light(s));
    }

    /// Error   light_table_max_error.
    /// Cost    nearest: one read; bilinear: four reads, and three or nine products.
    SHADE16_INLINE constexpr AccumulatorOf<C> light(const TableSample& s) const {
        if constexpr (N.bilinear)
            if (bilinear) return between(s);
        return as_light(entry[column(s.t) << light_table_log2 | column(s.s)]);
    }

private:
    static constexpr int32_t half = int32_t{1} << 20, last = (light_table_side << 21) - 1;

    SHADE16_INLINE static constexpr uint32_t column(int32_t c) { return static_cast<uint32_t>(clamp<int32_t>(c, 0, last)) >> 21; }
    SHADE16_INLINE static constexpr AccumulatorOf<C> as_light(uint16_t code) {
        if constexpr (C == Channels::luma) return {as_accumulator(Unorm16::from_raw(code))};
        else return as_accumulator(detail::as_rgb(code));
    }
    constexpr AccumulatorOf<C> between(const TableSample& s) const {
        const auto below = [](int32_t c) { return static_cast<uint32_t>(clamp<int32_t>(c - half, 0, last - 2 * half)); };
        const uint32_t x = below(s.s), y = below(s.t);
        detail::TexelCell cell{};
        cell.along_x = static_cast<int32_t>((x >> 6) & 32767), cell.along_y = static_cast<int32_t>((y >> 6) & 32767);
        const uint16_t* const first = entry + ((y >> 21) << light_table_log2 | x >> 21);
        const auto a = as_light(first[0]), b = as_light(first[1]), c = as_light(first[light_table_side]), d = as_light(first[light_table_side + 1]);
        AccumulatorOf<C> sum;
        for_each_channel<C>([&](uint32_t& to, uint32_t p, uint32_t q, uint32_t r, uint32_t t) {
            const auto in16 = [](uint32_t v) { return static_cast<int32_t>(min(v >> 8, uint32_t{65535})); };
            to = (static_cast<uint32_t>(detail::mixed(cell, in16(p), in16(q), in16(r), in16(t))) + 64) >> 7;
        }, sum, a, b, c, d);
        return sum;
    }
};

}  // namespace shade16
