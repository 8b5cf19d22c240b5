#include "campaign/detail/unsound.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "config/table.hpp"
#include "core/units.hpp"

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

// The largest value that a quantity can have in a trial that stands; infinite where nothing bounds it.
double largest_of(std::string_view quantity, BodySpec const& body) {
    double const alpha = std::max(body.body.corner(1).alpha_rad, body.body.corner(-1).alpha_rad);
    // In space a body that stands on a corner tilts further: at most as if it were flat.
    return quantity == "peak_rotation"         ? pi / 2
           : quantity == "peak_rotation_ratio" ? pi / 2 / alpha
                                               : std::numeric_limits<double>::infinity();
}

void refuse_out_of_reach(Table const& limit, LimitState const& state, std::span<BodySpec const> bodies) {
    if (state.rule != LimitState::Rule::above) {
        return;
    }
    bool const reached = std::ranges::any_of(
        bodies, [&](BodySpec const& body) { return state.threshold < largest_of(state.quantity.name, body); });
    if (!reached) {
        auto const& of = state.quantity;
        limit.fail(
            "above",
            fmt::format("{:g}{} of {} (it is at most {:.4g}: no trial passes that but by falling). {}", state.threshold,
                        of.units == "1" ? "" : " " + of.units, of.name, largest_of(of.name, bodies.front()),
                        of.units == "rad" ? fmt::format("Write \"{:g} deg\" if that was meant", state.threshold)
                                          : std::string("Lower it")));
    }
}

}  // namespace

void refuse_unsound(CampaignInput const& input, CampaignSpec const& spec) {
    auto const root = Table::parse(input.text, input.name, input.settings);
    refuse_bare_levels(root.child("levels"), spec.levels);
    if (!root.has("limits")) {
        return;
    }
    auto const limits = root.children("limits");
    for (std::size_t l = 0; l < limits.size(); ++l) {
        refuse_bare_threshold(limits[l], spec.limits.at(l + 1), spec.levels);
        refuse_out_of_reach(limits[l], spec.limits.at(l + 1), spec.bodies);
    }
}

}  // namespace overturn
