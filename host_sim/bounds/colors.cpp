#include "host_sim/bounds/entries.hpp"
#include "host_sim/bounds/exact.hpp"
#include "shade16/num/accumulator.hpp"

namespace shade16::bounds {
namespace {

double wide_luma(double r, double g, double b) {
    return (r * LumaWeights::red + g * LumaWeights::green + b * LumaWeights::blue) / 65536;
}
Rgb any_color(Dice& dice) {
    return {{static_cast<uint16_t>(dice.word())},
            {static_cast<uint16_t>(dice.word())},
            {static_cast<uint16_t>(dice.word())}};
}

double luma_error(Dice& dice) {
    const Rgb c = any_color(dice);
    const double exact = wide_luma(c.r.raw, c.g.raw, c.b.raw) / 65535 * 4294967295.0;
    const ColorFactor f{dice.word(), dice.word(), dice.word()};
    double worst = std::fabs(luma_of(c).luma - exact);
    worst = larger(worst, std::fabs(as_factor<Channels::luma>(c).luma - exact));
    worst = larger(worst, std::fabs(as_factor<Channels::luma>(f).luma - wide_luma(f.r, f.g, f.b)));
    const ColorFactor same = as_factor<Channels::rgb>(f), wide = as_factor<Channels::rgb>(c);
    return larger(worst, Differences()(same.r, f.r)(same.g, f.g)(same.b, f.b)(wide.r, c.r.widened())(
                             wide.g, c.g.widened())(wide.b, c.b.widened()));
}

double each_channel(Dice& dice) {
    ByChannel<Channels::rgb, uint32_t> sums{dice.word(), dice.word(), dice.word()};
    const ByChannel<Channels::rgb, uint32_t> before = sums, terms{dice.word(), dice.word(), dice.word()};
    ByChannel<Channels::luma, uint32_t> gray{dice.word()};
    const uint64_t gray_before = gray.luma;
    for_each_channel<Channels::rgb>([](uint32_t& sum, const uint32_t& term) { accumulate(sum, term); }, sums, terms);
    for_each_channel<Channels::luma>([](uint32_t& sum) { accumulate(sum, 5); }, gray);
    const auto saturated = [](uint64_t a, uint64_t b) { return std::min<uint64_t>(a + b, UINT32_MAX); };
    Differences worst;
    worst(sums.r, saturated(before.r, terms.r))(sums.g, saturated(before.g, terms.g))(sums.b,
                                                                                      saturated(before.b, terms.b));
    return worst(gray.luma, saturated(gray_before, 5));
}

}  // namespace

void add_colors(Entries& to) {
    to.add({.name = "Unorm16",
            .header = "num/unorm.hpp",
            .functions = "Unorm16::from_raw Unorm16::from_code8 Unorm16::widened rgb",
            .unit = "units"},
           [](uint64_t x) {
               const uint32_t word = static_cast<uint32_t>(x), clamped = std::min<uint32_t>(word, 65535);
               const Rgb c = rgb(word);
               Differences worst;
               worst(Unorm16::from_raw(word).raw, clamped)(Unorm16::from_code8(word).raw,
                                                           std::min<uint32_t>(word, 255) * 257);
               worst(uint64_t{Unorm16::from_raw(word).widened()} * 65535, uint64_t{clamped} * UINT32_MAX);
               return static_cast<double>(worst(c.r.raw, (word >> 16 & 255) * 257)(c.g.raw, (word >> 8 & 255) * 257)(
                   c.b.raw, (word & 255) * 257));
           });
    static constexpr uint32_t written[] = {(0_unorm).raw, (0.1_unorm).raw, (0.5_unorm).raw, (1_unorm).raw};
    static constexpr double meant[] = {0, 0.1, 0.5, 1};
    to.add({.name = "Unorm16 literals",
            .header = "num/unorm.hpp",
            .functions = "operator\"\"_unorm",
            .unit = "units",
            .bound = in_ulps(literal_max_error),
            .inputs = {0, std::size(written) - 1}},
           [](uint64_t i) { return std::fabs(written[i] - meant[i] * 65535); });
    to.add_random({.name = "luma",
                   .header = "num/channels.hpp",
                   .functions = "luma_of as_factor",
                   .unit = "2^-32",
                   .bound = luma_max_error},
                  luma_error);
    to.add_random({.name = "for_each_channel, accumulate",
                   .header = "num/channels.hpp num/accumulator.hpp",
                   .functions = "for_each_channel accumulate",
                   .unit = "2^-24"},
                  each_channel);
    to.add_random({.name = "scaled_term", .header = "num/accumulator.hpp", .functions = "scaled_term", .unit = "2^-24"},
                  [](Dice& dice) {
                      const uint32_t product = dice.word();
                      const int shift = dice.integer(-40, 40);
                      const uint64_t wanted =
                          shift >= 0 ? uint64_t{product} >> shift
                                     : std::min<uint64_t>(uint64_t{product} << std::min(-shift, 32), UINT32_MAX);
                      return static_cast<double>(Differences()(scaled_term(product, shift), wanted));
                  });
    to.add({.name = "as_accumulator",
            .header = "num/accumulator.hpp",
            .functions = "as_accumulator",
            .unit = "2^-24",
            .bound = in_ulps(as_accumulator_max_error),
            .inputs = {0, 65535}},
           [](uint64_t raw) {
               const Unorm16 c{static_cast<uint16_t>(raw)};
               const double exact = static_cast<double>(raw) / 65535 * 16777216;
               const auto rgb = as_accumulator(Rgb{c, c, c});
               const auto gray = as_accumulator<Channels::luma>(Rgb{c, c, c});
               return larger(std::fabs(as_accumulator(c) - exact),
                             Differences()(rgb.r, as_accumulator(c))(rgb.g, rgb.r)(rgb.b, rgb.r)(gray.luma, rgb.r));
           });
    to.add_random({.name = "as_accumulator, luma",
                   .header = "num/accumulator.hpp",
                   .functions = "as_accumulator",
                   .unit = "2^-24",
                   .bound = in_ulps(as_accumulator_max_error)},
                  [](Dice& dice) {
                      const Rgb c = any_color(dice);
                      const double exact = wide_luma(c.r.raw, c.g.raw, c.b.raw) / 65535 * 16777216;
                      return std::fabs(as_accumulator<Channels::luma>(c).luma - exact);
                  });
    static constexpr uint32_t weights[] = {LumaWeights::red, LumaWeights::green, LumaWeights::blue};
    static constexpr double shares[] = {0.299, 0.587, 0.114};  // ITU-R BT.601
    to.add({.name = "luma weights",
            .header = "num/channels.hpp",
            .functions = "",
            .unit = "2^-16",
            .bound = in_ulps(table_max_error),
            .inputs = {0, 2}},
           [](uint64_t i) { return std::fabs(weights[i] - shares[i] * 65536); });
}

}  // namespace shade16::bounds
