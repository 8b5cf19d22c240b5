#include "campaign/scatter.hpp"

#include <algorithm>
#include <array>

#include <gsl/gsl_rng.h>

#include "core/keyed_permutation.hpp"

namespace overturn {
namespace {

using config::Range;
using config::Table;

enum class Kind { fixed, normal, lognormal, uniform };

constexpr std::array kinds{config::Entry<Kind>{"fixed", "known exactly: value", Kind::fixed},
                           config::Entry<Kind>{"normal", "mean, deviation, low, high", Kind::normal},
                           config::Entry<Kind>{"lognormal", "median, beta, low, high", Kind::lognormal},
                           config::Entry<Kind>{"uniform", "low, high", Kind::uniform}};

Distribution read_stated(Table const& given, Kind kind, Dimension dimension, Range range) {
    switch (kind) {
        case Kind::fixed:
            return Distribution::fixed(given.number("value", dimension, range));
        case Kind::normal:
            return Distribution::normal(given.number("mean", dimension, range),
                                        given.number("deviation", dimension, Range::not_negative()));
        case Kind::lognormal:
            return Distribution::lognormal(given.number("median", dimension, range),
                                           given.number("beta", Dimension::none, {.low = 0, .high = 2}));
        case Kind::uniform:
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
    auto const kind = given.choice<Kind>("distribution", kinds);
    auto distribution = given.located("distribution", [&] { return read_stated(given, kind, dimension, range); });
    if (kind == Kind::normal || kind == Kind::lognormal) {
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
