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

constexpr std::string_view as_the_value = "the value";
constexpr config::Key share_of(std::string_view name, std::string_view meaning) {
    return config::number_key(name, Dimension::none, Range::any(), meaning).in_unit_of(as_the_value);
}
constexpr config::Keys distribution_keys{
    config::word_key<distribution_kinds>("distribution", "which one"),
    share_of("value", "the value itself").only("distribution = fixed"),
    share_of("mean", "mean").only("distribution = normal"),
    share_of("deviation", "standard deviation").only("distribution = normal"),
    share_of("median", "median").only("distribution = lognormal"),
    config::number_key("beta", Dimension::none, {.low = 0, .high = 2}, "standard deviation of the logarithm")
        .only("distribution = lognormal"),
    share_of("low", "lower limit; required for a uniform distribution").otherwise_in_words("limit of the key's range"),
    share_of("high", "upper limit; required for a uniform distribution")
        .otherwise_in_words("limit of the key's range")};

Distribution read_stated(Table const& given, DistributionKind kind, config::Given const& value) {
    switch (kind) {
        case DistributionKind::fixed:
            return Distribution::fixed(given.number(distribution_keys["value"], value));
        case DistributionKind::normal:
            return Distribution::normal(given.number(distribution_keys["mean"], value),
                                        given.number(distribution_keys["deviation"],
                                                     {.range = Range::not_negative(), .dimension = value.dimension}));
        case DistributionKind::lognormal:
            return Distribution::lognormal(given.number(distribution_keys["median"], value),
                                           given.number(distribution_keys["beta"]));
        case DistributionKind::uniform:
            break;
    }
    return Distribution::uniform(given.number(distribution_keys["low"], value),
                                 given.number(distribution_keys["high"], value));
}

// "138 t" and a deviation of 5: kilograms, or tonnes?
void refuse_bare(Table const& given, config::Key const& key) {
    constexpr std::array<std::string_view, 6> in_its_unit{"value", "mean", "deviation", "median", "low", "high"};
    auto const* const unit =
        std::ranges::find_if(in_its_unit, [&](std::string_view name) { return !given.unit_at(name).empty(); });
    auto const* const bare =
        std::ranges::find_if(in_its_unit, [&](std::string_view name) { return given.is_bare_at(name); });
    if (unit != in_its_unit.end() && bare != in_its_unit.end()) {
        given.fail(*bare, fmt::format("a number without a unit beside {} in {} (a bare number is {}). Write its unit",
                                      *unit, given.unit_at(*unit), si_symbol(key.dimension)));
    }
}

// What was written for an end of a band.
std::string end_of(Table const& given, config::Key const& end, std::string const& otherwise) {
    auto const kind = given.kind(end.name);
    return kind == config::Kind::text     ? fmt::format("\"{}\"", given.text(end.name))
           : kind == config::Kind::number ? fmt::format("{}", given.number(end))
                                          : otherwise;
}

// "{ distribution = "uniform", low = 0.3, high = 0.7 }", with the ends that `given` has.
std::string band_form(config::Key const& key, Table const* given) {
    bool const plain = key.dimension == Dimension::none;
    auto const low = plain ? "0.3" : fmt::format("\"1 {}\"", si_symbol(key.dimension));
    auto const high = plain ? "0.7" : fmt::format("\"2 {}\"", si_symbol(key.dimension));
    return fmt::format("{{ distribution = \"uniform\", low = {}, high = {} }}",
                       given == nullptr ? low : end_of(*given, distribution_keys["low"], low),
                       given == nullptr ? high : end_of(*given, distribution_keys["high"], high));
}

}  // namespace

bool looks_like_distribution(config::Table const& table) {
    return std::ranges::any_of(distribution_keys.all, [&](config::Key const& key) { return table.has(key.name); });
}

constinit config::KeyTable const distribution_table{.meaning = "uncertain value, drawn for each wave",
                                                    .keys = distribution_keys.all};

Distribution read_distribution(Table const& table, config::Key const& key) {
    if (table.kind(key.name) == config::Kind::list) {
        table.fail(key.name,
                   fmt::format("a list (must be one value or a band). A band is {}", band_form(key, nullptr)));
    }
    if (table.kind(key.name) != config::Kind::table) {
        return Distribution::fixed(table.number(key));
    }
    auto const given = table.child(key);
    config::Given const value{.range = key.range, .dimension = key.dimension};
    if (!given.has("distribution")) {
        given.fail_missing("distribution", "State which one; a band is " + band_form(key, &given));
    }
    auto const kind = given.choice<DistributionKind>(distribution_keys["distribution"], distribution_kinds);
    refuse_bare(given, key);  // before a bound in another unit leaves nothing of it
    auto distribution = given.located("distribution", [&] { return read_stated(given, kind, value); });
    if (kind == DistributionKind::normal || kind == DistributionKind::lognormal) {
        double const low = given.number(distribution_keys["low"],
                                        {.otherwise = key.range.low, .range = key.range, .dimension = key.dimension});
        double const high = given.number(distribution_keys["high"],
                                         {.otherwise = key.range.high, .range = key.range, .dimension = key.dimension});
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
