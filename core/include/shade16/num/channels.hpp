// Channels: what a pipeline lights and steps, three colours or their luma alone. A policy of the target: a grey one folds
// light and material to luma before any vertex is lit, and everything after that handles one number.
#pragma once

#include "shade16/num/mulhi.hpp"
#include "shade16/num/tier.hpp"

namespace shade16 {

enum class Channels : uint8_t { rgb, luma };

/// Luma, linear in display codes, in 1/65536. They sum to exactly one, so that white stays white and grey its own grey.
/// Source  ITU-R BT.601: 0.299, 0.587, 0.114.
struct LumaWeights {
    static constexpr uint32_t red = 19595, green = 38470, blue = 7471;
};

/// A colour folded to its luma, wider than the colour, so that folding costs no promise: 2^32 - 1 = 1.0, as ColorFactor.
struct Luma {
    uint32_t luma = 0;
    friend constexpr bool operator==(Luma, Luma) = default;
};

inline constexpr int luma_max_error = 1;  // of 2^-32; none for greys, which are their own luma

/// Range   any.  Error  luma_max_error.  Cost  three multiplies.  Source  LumaWeights, and 65537 / 65536 by a shift.
constexpr Luma luma_of(const Rgb& c) {
    const uint32_t sum = c.r.raw * LumaWeights::red + c.g.raw * LumaWeights::green + c.b.raw * LumaWeights::blue;  // one is 65535 * 65536
    return {sum + (sum >> 16)};
}

/// A number for each channel.
template <Channels C, class T>
struct ByChannel {
    T r{}, g{}, b{};
};
template <class T>
struct ByChannel<Channels::luma, T> {
    T luma{};
};

/// f of every channel of one or more things that have such members.
template <Channels C, class F, class... T>
SHADE16_INLINE constexpr void for_each_channel(F f, T&... c) {
    if constexpr (C == Channels::rgb) f(c.r...), f(c.g...), f(c.b...);
    else f(c.luma...);
}

namespace detail {
template <Channels C>
struct SelectFactor {
    using type = ColorFactor;
};
template <>
struct SelectFactor<Channels::luma> {
    using type = Luma;
};
}  // namespace detail

/// A colour as a factor, of a mesh or a texture, in a pipeline's channels.
template <Channels C>
using FactorIn = typename detail::SelectFactor<C>::type;

template <Channels C>
SHADE16_INLINE constexpr FactorIn<C> as_factor(const Rgb& c) {
    if constexpr (C == Channels::rgb) return c;
    else return luma_of(c);
}
/// Error: luma_max_error.
template <Channels C>
SHADE16_INLINE constexpr FactorIn<C> as_factor(const ColorFactor& c) {
    if constexpr (C == Channels::rgb) return c;
    else return {static_cast<uint32_t>((multiply(c.r, LumaWeights::red) + multiply(c.g, LumaWeights::green) + multiply(c.b, LumaWeights::blue)) >> 16)};
}

/// A tier as the stages of a grey pipeline see it: the same promise for one channel.
template <PrecisionTier Tier>
struct LumaTier : Tier {
    static constexpr Channels channels = Channels::luma;
};

namespace detail {
template <PrecisionTier Tier, Channels C>
struct SelectTier {
    using type = Tier;
};
template <PrecisionTier Tier>
struct SelectTier<Tier, Channels::luma> {
    using type = LumaTier<Tier>;
};
template <PrecisionTier Tier>
constexpr Channels channels_of_tier() {
    if constexpr (requires { Tier::channels; }) return Tier::channels;
    else return Channels::rgb;
}
}  // namespace detail

template <PrecisionTier Tier, Channels C>
using TierIn = typename detail::SelectTier<Tier, C>::type;

template <PrecisionTier Tier>
inline constexpr Channels channels_of = detail::channels_of_tier<Tier>();

}  // namespace shade16
