#include "output/detail/limit_text.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/outward.hpp"
#include "output/detail/interval_text.hpp"
#include "output/detail/level_columns.hpp"
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
    return fmt::format("{} [{}, {}]", std::isnan(q.value) ? "-" : value_text(at, q.value, unit.of(q.value)),
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

std::string limit_stripes_text(CampaignSpec const& spec, BodyStatistics const& counted, std::size_t limit,
                               bool sample) {
    auto const& stated = spec.limits[limit];
    auto const& of = counted.limits[limit - 1];
    auto text = fmt::format("\n{}, limit state {}: {}\n", counted.body, full_name(stated, spec.limits),
                            definition_of(stated, spec.limits));
    auto const levels = shown_levels(spec.levels);
    TextGroup counts{{"trials"}, {"exceeded"}, {"undecided"}, {"failed"}};
    TextGroup chances{{"P"}, {fmt::format("{:g} % interval", 100 * spec.confidence)}};
    for (auto const l : levels) {
        auto const& stripe = of.stripes[l];
        append_row(counts, std::array{std::to_string(stripe.trials), std::to_string(stripe.overturned),
                                      std::to_string(stripe.undecided), std::to_string(stripe.failed)});
        append_row(chances, std::array{estimate_text(stripe), interval_text(stripe.interval(spec.confidence))});
    }
    std::vector<TextGroup> groups{{level_column(spec.levels, levels)}, counts};
    if (sample) {
        groups.push_back(chances);
    }
    groups.push_back({purpose_column(spec.levels, levels)});
    text += columns_text(groups);
    text += left_out_levels(spec.levels);
    if (of.unknown > 0) {
        text += fmt::format(
            "note: {} trials have a verdict, but the quantity of {} is not known: they count as undecided\n",
            of.unknown, stated.name);
    }
    if (of.fell_within > 0) {
        text += fmt::format(
            "note: {} trials overturned and had not exceeded {} before: they count as within it. To count them as "
            "exceeded, state any = [\"{}\", \"{}\"]\n",
            of.fell_within, stated.name, stated.name, overturning_limit);
    }
    return text;
}

std::string quantiles_text(CampaignSpec const& spec, BodyAnalysis const& body, double confidence) {
    std::string text;
    std::string quantity;
    std::vector<TextGroup> table;
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
        auto const moves = [&](LevelQuantiles const& other) { return of_it(other) && other.most > 0; };
        if (std::ranges::none_of(body.quantiles, moves)) {
            continue;
        }
        auto const unit = shown_unit(spec, at.units);
        if (at.quantity != quantity) {
            quantity = at.quantity;
            text += table.empty() ? std::string() : columns_text(table, 2);
            text += fmt::format("  {}{} of the trials, with {:g} % intervals (free of any distribution)\n", quantity,
                                unit.symbol == "1" ? "" : " " + unit.symbol, 100 * confidence);
            table = {{{fmt::format("{} {}", levels.name, levels.shown_in.symbol)}},
                     {{"median"}},
                     {{"84 %"}},
                     {{"95 %"}},
                     {{"", {}, TextColumn::Side::left}}};
        }
        table.front().front().cells.push_back(fmt::format("{:.4g}", levels.shown_in.of(at.amplitude)));
        for (std::size_t q = 0; q < at.quantiles.size(); ++q) {
            table[1 + q].front().cells.push_back(at.trials == 0 ? "unknown" : quantile_text(at, at.quantiles[q], unit));
        }
        table.back().front().cells.push_back(at.trials > 0 && at.unknown > 0 ? fmt::format("{} unknown", at.unknown)
                                                                             : std::string());
    }
    return text + (table.empty() ? std::string() : columns_text(table, 2));
}

}  // namespace overturn::output
