#include "results/detail/limit_results.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/field.hpp"
#include "results/detail/column_values.hpp"
#include "results/fragility_schema.hpp"
#include "results/shown_levels.hpp"

namespace overturn {
namespace {

std::string group_of(LimitState const& limit, char const* what, std::string const& body) {
    return fmt::format("limits/{}/{}/{}", limit.name, what, body);
}

void write_stripes(store::ResultsWriter& file, CampaignSpec const& spec, std::string const& group,
                   std::vector<Stripe> const& stripes, bool grid) {
    file.array(group, {"amplitude", spec.levels.units(), "value of the level"},
               column_values<double>(stripes, [](Stripe const& s) { return s.amplitude; }));
    auto const put = [&](char const* name, char const* description, auto const& values) {
        file.array(group, {name, "1", description}, values, "amplitude");
    };
    double const c = spec.confidence;
    put("trials", "trials at the level",
        column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.trials; }));
    put("exceeded", "trials that exceeded the limit",
        column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.overturned; }));
    put("failed", "trials without a verdict, for a reason; left out of the probability",
        column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.failed; }));
    put("undecided", "further trials that do not tell; left out of the probability",
        column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.undecided; }));
    auto const chance = [&](char const* name, char const* description, auto get) {
        put(name, grid ? no_chance : description,
            column_values<double>(stripes, [&](Stripe const& s) { return grid ? never : get(s); }));
    };
    chance("probability", "exceeded over decided trials; NaN where none is decided",
           [](Stripe const& s) { return s.probability(); });
    chance("lower", "lower bound, Clopper-Pearson, undecided trials counted as within the limit",
           [c](Stripe const& s) { return s.interval(c).lower; });
    chance("upper", "upper bound, Clopper-Pearson, undecided trials counted as exceeding it",
           [c](Stripe const& s) { return s.interval(c).upper; });
    file.attribute(group, "confidence", c);
    file.attribute(group, "level_measure", spec.levels.measure_name());
}

// "fell" where the value stands for a body that overturned.
std::string value_text(LevelQuantiles const& at, double value) {
    return value >= at.fallen ? std::string("fell") : fmt::format("{:.3g}", value);
}

std::string quantile_text(LevelQuantiles const& at, SampleQuantile const& q) {
    auto const end = [&](std::optional<double> const& value) { return value ? value_text(at, *value) : "open"; };
    return fmt::format("{} [{}, {}]", value_text(at, q.value), end(q.lower), end(q.upper));
}

constexpr std::array quantile_names{"median", "p84", "p95"};

}  // namespace

void write_limits(store::ResultsWriter& file, CampaignSpec const& spec, Statistics const& statistics,
                  std::vector<BodyAnalysis> const& analysis) {
    for (std::size_t l = 1; l < spec.limits.size(); ++l) {
        auto const& limit = spec.limits[l];
        for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
            auto const& body = statistics.bodies()[b];
            write_stripes(file, spec, group_of(limit, "stripes", body.body), body.stripes_of(l), !body.grid.empty());
            write_fragility(file, group_of(limit, "fragility", body.body), analysis[b].limits[l - 1].fragility,
                            spec.confidence);
        }
        file.attribute("limits/" + limit.name, "definition", definition_of(limit, spec.limits));
    }
}

void write_quantiles(store::ResultsWriter& file, CampaignSpec const& spec, BodyAnalysis const& body) {
    auto const group = "quantiles/" + body.body;
    auto const levels = spec.levels.levels.size();
    std::vector<double> amplitudes;
    std::ranges::transform(spec.levels.levels, std::back_inserter(amplitudes), &Level::value);
    file.array(group, {"amplitude", spec.levels.units(), "value of the level"}, amplitudes);
    for (std::size_t first = 0; first < body.quantiles.size(); first += levels) {
        auto const rows = std::span(body.quantiles).subspan(first, levels);
        auto const& of = rows.front();
        auto const put = [&](std::string const& name, std::string const& description, auto get) {
            std::vector<double> values;
            std::ranges::transform(rows, std::back_inserter(values), get);
            file.array(group, {of.quantity + "_" + name, of.units, description}, values, "amplitude");
        };
        for (std::size_t q = 0; q < quantile_names.size(); ++q) {
            std::string const name = quantile_names.at(q);
            put(name,
                fmt::format("value that {:g} % of the trials at the level do not exceed", 100 * of.quantiles[q].share),
                [q](LevelQuantiles const& at) { return at.quantiles.at(q).value; });
            put(name + "_lower", "its lower end, an order statistic; NaN: open",
                [q](LevelQuantiles const& at) { return at.quantiles.at(q).lower.value_or(never); });
            put(name + "_upper", "its upper end, an order statistic; NaN: open",
                [q](LevelQuantiles const& at) { return at.quantiles.at(q).upper.value_or(never); });
        }
    }
    file.attribute(group, "confidence", spec.confidence);
}

void require_stored_limits(store::ResultsReader const& file, CampaignSpec const& spec, BodyStatistics const& counted) {
    for (std::size_t l = 1; l < spec.limits.size(); ++l) {
        auto const group = group_of(spec.limits[l], "stripes", counted.body);
        auto const& stripes = counted.stripes_of(l);
        bool const same = file.integers(group + "/trials")
                              == column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.trials; })
                          && file.integers(group + "/exceeded")
                                 == column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.overturned; })
                          && file.integers(group + "/undecided")
                                 == column_values<std::int64_t>(stripes, [](Stripe const& s) { return s.undecided; });
        validate(same,
                 "results file: {} does not agree with its trials (it is damaged, or not of this program). Run the "
                 "campaign again",
                 group);
    }
}

std::string limit_stripes_text(CampaignSpec const& spec, BodyStatistics const& counted, std::size_t limit) {
    auto const& stated = spec.limits[limit];
    auto const& of = counted.limits[limit - 1];
    bool const grid = !counted.grid.empty();
    auto text = fmt::format(
        "\n{}, limit state {}: {}\n{:>10} {:>7} {:>8} {:>9} {:>7}{}\n", counted.body, stated.name,
        definition_of(stated, spec.limits), fmt::format("{} {}", spec.levels.measure_name(), spec.levels.shown_units()),
        "trials", "exceeded", "undecided", "failed",
        grid ? std::string()
             : fmt::format("  {:>8}  {:>20}", "P", fmt::format("{:g} % interval", 100 * spec.confidence)));
    for (auto const l : shown_levels(spec.levels)) {
        auto const& stripe = of.stripes[l];
        auto const interval = stripe.interval(spec.confidence);
        auto const p = stripe.decided() == 0
                           ? std::string("-")
                           : fmt::format("{}{:.4f}", stripe.decided() < stripe.trials ? "~" : "", stripe.probability());
        auto const purpose = spec.levels.levels[l].purpose;
        auto const chance =
            grid ? std::string() : fmt::format("  {:>8}  [{:.6f}, {:.6f}]", p, interval.lower, interval.upper);
        text += fmt::format("{:>10.4g} {:>7} {:>8} {:>9} {:>7}{}{}\n", spec.levels.shown(stripe.amplitude),
                            stripe.trials, stripe.overturned, stripe.undecided, stripe.failed, chance,
                            purpose == LevelClass::ordinary ? std::string() : fmt::format("  {}", name_of(purpose)));
    }
    text += left_out_levels(spec.levels);
    if (of.unknown > 0) {
        text += fmt::format("note: {} trials with a verdict do not tell what {} asks for and are left out\n",
                            of.unknown, stated.name);
    }
    if (of.fell_within > 0) {
        text += fmt::format(
            "note: {} trials overturned without exceeding {} before they did, and count as within it; a limit state "
            "any = [\"{}\", \"{}\"] counts them\n",
            of.fell_within, stated.name, stated.name, overturning_limit);
    }
    return text;
}

std::string quantiles_text(BodyAnalysis const& body, double confidence) {
    std::string text;
    std::string quantity;
    auto const& levels = body.over_levels();
    std::size_t count = 0;
    for (auto const& at : body.quantiles) {
        count = std::max(count, at.level + 1);
    }
    auto const shown = spread_places(count);
    for (auto const& at : body.quantiles) {
        if (!std::ranges::binary_search(shown, at.level)) {
            continue;
        }
        auto const of_it = [&](LevelQuantiles const& other) { return other.quantity == at.quantity; };
        auto const moves = [&](LevelQuantiles const& other) {
            return of_it(other) && other.quantiles.back().value > 0;
        };
        if (std::ranges::none_of(body.quantiles, moves)) {
            continue;
        }
        if (at.quantity != quantity) {
            quantity = at.quantity;
            text += fmt::format(
                "  {}{} of the trials, with {:g} % intervals between order statistics\n  {:>10} {:>28} "
                "{:>28} {:>28}\n",
                quantity, at.units == "1" ? "" : " " + at.units, 100 * confidence,
                fmt::format("{} {}", levels.name, levels.told.symbol), "median", "84 %", "95 %");
        }
        text += at.trials == 0 ? fmt::format("  {:>10.4g} unknown\n", levels.told.of(at.amplitude))
                               : fmt::format("  {:>10.4g} {:>28} {:>28} {:>28}{}\n", levels.told.of(at.amplitude),
                                             quantile_text(at, at.quantiles[0]), quantile_text(at, at.quantiles[1]),
                                             quantile_text(at, at.quantiles[2]),
                                             at.unknown > 0 ? fmt::format("  {} unknown", at.unknown) : std::string());
    }
    return text;
}

}  // namespace overturn
