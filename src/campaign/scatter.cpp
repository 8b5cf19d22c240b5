#include "campaign/scatter.hpp"

#include <algorithm>
#include <array>

#include <gsl/gsl_rng.h>

#include "core/keyed_permutation.hpp"

namespace overturn {
namespace {

using config::Range;
using config::Table;

enum class DistributionKind { fixed, normal, lognormal, uniform };

constexpr std::array distribution_kinds{
    config::Entry<DistributionKind>{"fixed", "known exactly: value", DistributionKind::fixed},
    config::Entry<DistributionKind>{"normal", "mean, deviation, low, high", DistributionKind::normal},
    config::Entry<DistributionKind>{"lognormal", "median, beta, low, high", DistributionKind::lognormal},
    config::Entry<DistributionKind>{"uniform", "low, high", DistributionKind::uniform}};

Distribution read_stated(Table const& given, DistributionKind kind, Dimension dimension, Range range) {
    switch (kind) {
        case DistributionKind::fixed:
            return Distribution::fixed(given.number("value", dimension, range));
        case DistributionKind::normal:
            return Distribution::normal(given.number("mean", dimension, range),
                                        given.number("deviation", dimension, Range::not_negative()));
        case DistributionKind::lognormal:
            return Distribution::lognormal(given.number("median", dimension, range),
                                           given.number("beta", Dimension::none, {.low = 0, .high = 2}));
        case DistributionKind::uniform:
            break;
    }
    return Distribution::uniform(given.number("low", dimension, range), given.number("high", dimension, range));
}

}  // namespace

Distribution read_distribution(Table const& table, std::string_view key, Dimension dimension, Range range) {
    if (table.kind(key) != config::Kind::table) {
        return Distribution::fixed(table.number(key, dimension, range));
    }
    auto const given = table.child(key);
    auto const kind = given.choice<DistributionKind>("distribution", distribution_kinds);
    auto distribution = given.located("distribution", [&] { return read_stated(given, kind, dimension, range); });
    if (kind == DistributionKind::normal || kind == DistributionKind::lognormal) {
        double const low = given.number("low", dimension, range, range.low);
        double const high = given.number("high", dimension, range, range.high);
        distribution = given.located("distribution", [&] { return distribution.truncated(low, high); });
    }
    given.finish();
    return distribution;
}

double uniform_for(DrawnFor const& wave, Purpose purpose, std::uint64_t index) {
    RandomStream stream(wave.seed, wave.wave, purpose, index);
    double const within = gsl_rng_uniform_pos(stream.gsl());
    if (wave.sampling == Sampling::independent) {
        return within;
    }
    KeyedPermutation const slice(wave.seed, wave.group, purpose, index, wave.count);
    constexpr double largest = 1 - 0x1p-53;
    return std::min(largest, (static_cast<double>(slice(wave.place)) + within) / static_cast<double>(wave.count));
}

}  // namespace overturn
