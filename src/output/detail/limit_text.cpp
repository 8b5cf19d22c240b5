#include "output/detail/limit_text.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/outward.hpp"
#include "output/interval_text.hpp"
#include "output/shown_levels.hpp"

namespace overturn::output {
namespace {

// "fell" where the value stands for a body that overturned.
std::string value_text(LevelQuantiles const& at, double value, double shown) {
    return value >= at.fallen ? std::string("fell") : fmt::format("{:.3g}", shown);
}

std::string quantile_text(LevelQuantiles const& at, SampleQuantile const& q, IntensityUnit const& unit) {
    auto const end = [&](std::optional<double> const& value, auto outwards) {
        return value ? value_text(at, *value, outwards(unit.of(*value))) : std::string("open");
    };
    return fmt::format("{} [{}, {}]", value_text(at, q.value, unit.of(q.value)),
                       end(q.lower, [](double shown) { return rounded_down(shown); }),
                       end(q.upper, [](double shown) { return rounded_up(shown); }));
}

}  // namespace

std::string estimate_text(Stripe const& stripe) {
    if (stripe.decided() == 0) {
        return "-";
    }
    return fmt::format("{}{:.4f}", stripe.decided() < stripe.trials ? "~" : "", stripe.probability());
}

std::string limit_stripes_text(CampaignSpec const& spec, BodyStatistics const& counted, std::size_t limit) {
    auto const& stated = spec.limits[limit];
    auto const& of = counted.limits[limit - 1];
    bool const grid = !counted.grid.empty();
    auto text = fmt::format(
        "\n{}, limit state {}: {}\n{:>10} {:>7} {:>8} {:>9} {:>7}{}\n", counted.body, said_name(stated, spec.limits),
        definition_of(stated, spec.limits), fmt::format("{} {}", spec.levels.measure_name(), spec.levels.shown_units()),
        "trials", "exceeded", "undecided", "failed",
        grid ? std::string()
             : fmt::format("  {:>8}  {:>20}", "P", fmt::format("{:g} % interval", 100 * spec.confidence)));
    for (auto const l : shown_levels(spec.levels)) {
        auto const& stripe = of.stripes[l];
        auto const interval = stripe.interval(spec.confidence);
        auto const purpose = spec.levels.levels[l].purpose;
        auto const chance =
            grid ? std::string() : fmt::format("  {:>8}  {}", estimate_text(stripe), millionths_text(interval));
        text += fmt::format("{:>10.4g} {:>7} {:>8} {:>9} {:>7}{}{}\n", spec.levels.shown(stripe.amplitude),
                            stripe.trials, stripe.overturned, stripe.undecided, stripe.failed, chance,
                            purpose == LevelClass::ordinary ? std::string() : fmt::format("  {}", name_of(purpose)));
    }
    text += left_out_levels(spec.levels);
    if (of.unknown > 0) {
        text += fmt::format("note: {} trials have a verdict but not the quantity of {}: they are undecided\n",
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

std::string quantiles_text(CampaignSpec const& spec, BodyAnalysis const& body, double confidence) {
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
        auto const unit = shown_unit(spec, at.units);
        if (at.quantity != quantity) {
            quantity = at.quantity;
            text += fmt::format(
                "  {}{} of the trials, with {:g} % intervals between order statistics\n  {:>10} {:>28} "
                "{:>28} {:>28}\n",
                quantity, unit.symbol == "1" ? "" : " " + unit.symbol, 100 * confidence,
                fmt::format("{} {}", levels.name, levels.shown_in.symbol), "median", "84 %", "95 %");
        }
        text += at.trials == 0
                    ? fmt::format("  {:>10.4g} unknown\n", levels.shown_in.of(at.amplitude))
                    : fmt::format("  {:>10.4g} {:>28} {:>28} {:>28}{}\n", levels.shown_in.of(at.amplitude),
                                  quantile_text(at, at.quantiles[0], unit), quantile_text(at, at.quantiles[1], unit),
                                  quantile_text(at, at.quantiles[2], unit),
                                  at.unknown > 0 ? fmt::format("  {} unknown", at.unknown) : std::string());
    }
    return text;
}

}  // namespace overturn::output
