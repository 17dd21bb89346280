// ScreenVertex: what the pipeline keeps of a vertex, 14 bytes in the 16-bit tiers.
#pragma once

#include "shade16/num/accumulator.hpp"
#include "shade16/num/tier.hpp"

namespace shade16 {

/// Which planes a vertex lies outside of. `near_plane` and the guard band call for clipping; the frame's own edges do not.
enum Outcode : uint16_t {
    outside_left = 1, outside_right = 2, outside_top = 4, outside_bottom = 8, outside_near = 16,
    outside_any = 31,
    is_transformed = 64, is_lit = 128,
};

/// A colour after light, saturated to white: Q15 in the 16-bit tiers, Q24 in highp.
template <bool Wide>
struct ChannelOf {
    using type = uint16_t;
    static constexpr int bits = 15;
};
template <>
struct ChannelOf<true> {
    using type = uint32_t;
    static constexpr int bits = 24;
};

/// x and y in 1/16 pixel from the centre of the frame, so that 2048 pixels and a guard band fit 16 bits; y points down.
/// Depth runs from first_depth at the near plane to last_depth at the far one. With an outcode set, only flags and colours are valid.
template <PrecisionTier Tier>
struct ScreenVertex {
    using Channel = typename ChannelOf<Arithmetic<Tier>::wide>::type;
    static constexpr int channel_bits = ChannelOf<Arithmetic<Tier>::wide>::bits;

    int16_t x = 0, y = 0;
    uint16_t z = 0;
    uint16_t flags = 0;
    Channel r = 0, g = 0, b = 0;

    constexpr void set_color(const Accumulator& sum) {
        r = channel(sum.r), g = channel(sum.g), b = channel(sum.b);
        flags = static_cast<uint16_t>(flags | is_lit);
    }

private:
    static constexpr Channel channel(uint32_t sum) {
        const uint32_t saturated = min(sum, Accumulator::one);
        if constexpr (channel_bits == 24) return saturated;
        return static_cast<Channel>((saturated + 256) >> 9);
    }
};

/// The same of a grey pipeline: 10 bytes in the 16-bit tiers. It saturates its luma, not the luma of saturated channels.
template <PrecisionTier Tier>
    requires(channels_of<Tier> == Channels::luma)
struct ScreenVertex<Tier> {
    using Channel = typename ChannelOf<Arithmetic<Tier>::wide>::type;
    static constexpr int channel_bits = ChannelOf<Arithmetic<Tier>::wide>::bits;

    int16_t x = 0, y = 0;
    uint16_t z = 0;
    uint16_t flags = 0;
    Channel luma = 0;

    constexpr void set_color(const AccumulatorOf<Channels::luma>& sum) {
        const uint32_t saturated = min(sum.luma, Accumulator::one);
        luma = static_cast<Channel>(channel_bits == 24 ? saturated : (saturated + 256) >> 9);
        flags = static_cast<uint16_t>(flags | is_lit);
    }
};

}  // namespace shade16
