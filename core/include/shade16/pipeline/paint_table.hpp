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

namespace detail {
/// Four entries about a place, and their weights in 32nds.
struct TableCell {
    const uint16_t* first;
    uint32_t weight[4];  // of the entry itself, the one beside it, the one in the next row, and beyond that

    constexpr TableCell(const uint16_t* entry, const TableSample& s) : first(entry), weight{} {
        constexpr int32_t half = int32_t{1} << 20, last = (light_table_side << 21) - 1;
        const auto below = [](int32_t c) { return static_cast<uint32_t>(clamp<int32_t>(c - half, 0, last - 2 * half)); };
        const uint32_t x = below(s.s), y = below(s.t), along = (x >> 16) & 31, down = (y >> 16) & 31;
        first += (y >> 21) << light_table_log2 | x >> 21;
        weight[3] = along * down >> 5;
        weight[1] = along - weight[3], weight[2] = down - weight[3], weight[0] = 32 - along - weight[2];
    }
    /// `read` of each entry, times its weight.
    template <class Read>
    SHADE16_INLINE constexpr uint32_t sum(Read read) const {
        return read(first[0]) * weight[0] + read(first[1]) * weight[1] + read(first[light_table_side]) * weight[2] + read(first[light_table_side + 1]) * weight[3];
    }
};

/// RGB565 with room for five fraction bits above each channel: [green | red | blue].
inline constexpr uint32_t spread_mask = 0x07E0F81F, spread_half = uint32_t{16} << 21 | uint32_t{16} << 11 | 16;
SHADE16_INLINE constexpr uint32_t spread(uint16_t code) { return (code | uint32_t{code} << 16) & spread_mask; }
}  // namespace detail

/// What looks a pixel's colour up.
template <Needs N, Channels C>
struct TableLight {
    using Kind = TableKind;

    const uint16_t* entry;
    bool bilinear;

    /// Error   light_table_max_error.
    /// Cost    M3: nearest 38 instructions a pixel, bilinear 90, walking included; light a pixel takes 190.
    template <PixelFormat Format>
    SHADE16_INLINE constexpr typename Format::Pixel pixel(const TableSample& s) const {
        if constexpr (requires { Format::from_rgb565(uint16_t{}); }) return Format::from_rgb565(code(s));
        else return detail::pixel_of_light<Format>(light(s));
    }
    template <PixelFormat Format>
    [[gnu::noinline]] constexpr ByChannel<C, uint32_t> codes(const TableSample& s) const {
        return detail::codes_of_light<Format>(light(s));
    }
    constexpr AccumulatorOf<C> light(const TableSample& s) const {
        if constexpr (N.bilinear)
            if (bilinear) return between(s);
        return as_light(nearest(s));
    }

private:
    SHADE16_INLINE static constexpr uint32_t column(int32_t c) {
        return static_cast<uint32_t>(clamp<int32_t>(c, 0, (light_table_side << 21) - 1)) >> 21;
    }
    SHADE16_INLINE constexpr uint16_t nearest(const TableSample& s) const { return entry[column(s.t) << light_table_log2 | column(s.s)]; }

    /// RGB565, rounded once.
    SHADE16_INLINE constexpr uint16_t code(const TableSample& s) const {
        if constexpr (N.bilinear)
            if (bilinear) {
                const uint32_t codes = (detail::TableCell(entry, s).sum(detail::spread) + detail::spread_half) >> 5 & detail::spread_mask;
                return static_cast<uint16_t>(codes | codes >> 16);
            }
        return nearest(s);
    }
    SHADE16_INLINE static constexpr AccumulatorOf<C> as_light(uint16_t code) {
        if constexpr (C == Channels::luma) return {as_accumulator(Unorm16::from_raw(code))};
        else return as_accumulator(detail::as_rgb(code));
    }
    constexpr AccumulatorOf<C> between(const TableSample& s) const {
        const detail::TableCell cell(entry, s);
        if constexpr (C == Channels::luma) {
            return {as_accumulator(Unorm16::from_raw((cell.sum([](uint16_t luma) { return uint32_t{luma}; }) + 16) >> 5))};
        } else {
            const uint32_t sum = cell.sum(detail::spread);
            constexpr uint32_t of_five_bits = 541'200, of_six_bits = 532'610;  // 2^24 / (31 * 32) as Q5, 2^24 / (63 * 32) as Q6
            return {(sum >> 11 & 0x3FF) * of_five_bits >> 5, (sum >> 21) * of_six_bits >> 6, (sum & 0x3FF) * of_five_bits >> 5};
        }
    }
};

}  // namespace shade16
