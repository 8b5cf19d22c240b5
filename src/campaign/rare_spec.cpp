#include "campaign/rare_spec.hpp"

#include <array>

#include "rare/crude.hpp"

namespace overturn {
namespace {

using Wish = std::optional<rare::Method>;

constexpr std::array rare_methods{
    config::Entry<Wish>{"auto", "suitable estimator for each level; another one if its checks fail", std::nullopt},
    config::Entry<Wish>{"pulse-mixture", "importance sampling with the pulses that failing waves have in common",
                        rare::Method::pulse_mixture},
    config::Entry<Wish>{"subset", "subset simulation, for any random waves", rare::Method::subset},
    config::Entry<Wish>{"crude", "crude Monte Carlo", rare::Method::crude},
};

constexpr std::int64_t fewest_replicates = 4;  // fewer give no interval
constexpr std::int64_t most_replicates = 4095;
constexpr std::int64_t fewest_counted = 1000;
constexpr std::int64_t most_runs = 1'000'000'000;
constexpr config::Keys rare_keys{
    config::word_key<rare_methods>("method", "estimator of rare events").otherwise("auto"),
    config::number_key("target_cov", Dimension::none, {.low = 0.01, .high = 1}, "target coefficient of variation of P")
        .otherwise(RareSpec{}.target_cov),
    config::integer_key("replicates", fewest_replicates, most_replicates,
                        "number of independent estimates; up to four times as many to meet target_cov")
        .otherwise(RareSpec{}.replicates),
    config::integer_key(
        "max_runs", fewest_counted, most_runs,
        "largest number of trials of an estimator; the search for an amplitude at which failure is common may "
        "take as many beside, and the first stage of subset simulation is completed in any case; at "
        "least 20000 unless crude")
        .otherwise(RareSpec{}.max_runs)};

void check_levels(config::Table const& root, LevelSpec const& levels) {
    if (levels.measure != measure_named("factor")) {
        root.child("levels").fail(
            "measure",
            fmt::format("{} beside [rare] (each wave would be scaled to its own value, and no estimator does "
                        "better than plain trials there). Use measure = 'factor', one factor for all waves",
                        levels.measure_name()));
    }
    if (levels.levels.size() >= rare::most_factors) {
        root.child("levels").fail("values", fmt::format("{} levels beside [rare] (at most {}). State fewer",
                                                        levels.levels.size(), rare::most_factors - 1));
    }
}

void check_waves(config::Table const& root, WaveSource const& source, Wish const& method) {
    if (root.child("waves").has("aftershock")) {
        root.child("waves").fail("aftershock",
                                 "beside [rare] (rare events are sought among single shocks). Leave one of them out");
    }
    auto const waves = source.from_normals();
    if (waves == nullptr) {
        root.child("waves").fail(
            "source",
            "beside [rare] (its waves are not drawn at random, or components have a stated correlation). Use "
            "filtered-noise, or spectrum-compatible without a seed and a correlation");
    }
    if (method == rare::Method::pulse_mixture && !waves->linear()) {
        root.child("rare").fail("method",
                                "pulse-mixture for waves that are not linear in their random numbers (it would "
                                "be wrong by decades). Use auto or subset, or waves with match = 'none' and "
                                "amplitudes = 'gaussian'");
    }
}

}  // namespace

constinit config::KeyTable const rare_keys_table{.meaning = "small probabilities, estimated at every level",
                                                 .keys = rare_keys.all};

std::optional<RareSpec> read_rare(config::Table const& root, LevelSpec const& levels, WaveSource const& source) {
    if (!root.has("rare")) {
        return std::nullopt;
    }
    auto const table = root.child("rare");
    RareSpec spec;
    spec.method = table.choice<Wish>(rare_keys["method"], rare_methods);
    spec.target_cov = table.number(rare_keys["target_cov"]);
    spec.replicates = table.integer(rare_keys["replicates"]);
    // A first look and the first stage of an estimator; plain trials are counted however few.
    std::int64_t const fewest_runs = spec.method == rare::Method::crude ? fewest_counted : 20'000;
    spec.max_runs = table.integer(rare_keys["max_runs"], {.least = fewest_runs});
    table.finish();
    check_levels(root, levels);
    check_waves(root, source, spec.method);
    return spec;
}

}  // namespace overturn
