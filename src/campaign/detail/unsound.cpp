#include "campaign/detail/unsound.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "campaign/detail/limit_range.hpp"
#include "config/table.hpp"

namespace overturn {
namespace {

using config::Table;

void refuse_bare_levels(Table const& levels, LevelSpec const& spec) {
    for (std::string_view const key : {"values", "design_basis", "beyond_design"}) {
        if (!spec.stated_unit.empty() && levels.is_bare_at(key)) {
            levels.fail(key, fmt::format("a number without a unit beside levels in {0} (is it {0} or {1}?). Write its "
                                         "unit",
                                         spec.stated_unit, spec.units()));
        }
    }
}

void refuse_bare_threshold(Table const& limit, LimitState const& state, LevelSpec const& levels) {
    auto const& units = state.quantity.units;
    if (levels.stated_unit.empty() || units == "1" || units == "J/kg") {
        return;
    }
    for (std::string_view const key : {"above", "below"}) {
        if (limit.has(key) && limit.is_bare_at(key)) {
            limit.fail(key, fmt::format("{:g} without a unit beside levels in {} (a bare number is {}). Write its unit",
                                        state.threshold, levels.stated_unit, units));
        }
    }
}

// What all bodies answer in common; else some trials pass.
Passable passable_by_all(LimitState const& state, std::span<BodySpec const> bodies) {
    auto const of = [&](BodySpec const& body) { return passable(state, range_of(state.quantity, body)); };
    auto const first = of(bodies.front());
    bool const same = std::ranges::all_of(bodies, [&](BodySpec const& body) { return of(body) == first; });
    return same ? first : Passable::some;
}

// A threshold that no trial passes but by falling, or that every trial passes.
void refuse_out_of_reach(Table const& limit, LimitState const& state, std::span<BodySpec const> bodies) {
    if (state.rule != LimitState::Rule::above && state.rule != LimitState::Rule::below) {
        return;
    }
    auto const reach = passable_by_all(state, bodies);
    if (reach == Passable::some) {
        return;
    }
    bool const above = state.rule == LimitState::Rule::above;
    bool const too_high = above == (reach == Passable::none);
    auto const range = range_of(state.quantity, bodies.front());
    auto const& units = state.quantity.units;
    auto const symbol = !state.shown.symbol.empty() ? state.shown.symbol : units == "1" ? std::string() : units;
    auto const text_of = [&](double value) {
        return fmt::format("{:.4g}{}{}", state.shown.of(value), symbol.empty() ? "" : " ", symbol);
    };
    auto const bound = too_high ? "at most " + text_of(range.most)
                       : std::isnormal(range.least)
                           ? fmt::format("at least {}, of a body at rest too", text_of(range.least))
                           : std::string("never 0");
    auto const* const who = reach == Passable::none ? "no trial passes that but by falling" : "every trial passes that";
    bool const of_degrees = too_high && above && state.quantity.units == "rad" && state.shown.symbol.empty();
    limit.fail(above ? "above" : "below",
               fmt::format("{} of {} (it is {}: {}). {}", state.threshold_text(), state.quantity.name, bound, who,
                           of_degrees ? fmt::format("Write \"{:g} deg\" if that was meant", state.threshold)
                           : too_high ? std::string("Lower it")
                                      : std::string("Raise it")));
}

}  // namespace

void refuse_unsound(CampaignInput const& input, CampaignSpec const& spec) {
    auto const root = Table::parse(input.text, input.name, input.settings);
    refuse_bare_levels(root.child("levels"), spec.levels);
    if (!root.has("limits")) {
        return;
    }
    auto const limits = root.children("limits");
    auto const before = spec.limits.size() - limits.size();  // those that are there without being stated
    for (std::size_t l = 0; l < limits.size(); ++l) {
        refuse_bare_threshold(limits[l], spec.limits.at(before + l), spec.levels);
        refuse_out_of_reach(limits[l], spec.limits.at(before + l), spec.bodies);
    }
}

}  // namespace overturn
