#include "campaign/typed_units.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace overturn {
namespace {

using Unit = std::optional<IntensityUnit>;
using Source = std::function<Unit()>;

// Of a number that was written as "258 kip".
Unit unit_of(config::InputValue const& input) {
    auto const blank = input.text.find(' ');
    return blank == std::string::npos || input.basis == config::Basis::by_default
               ? std::nullopt
               : unit_named(std::string_view(input.text).substr(blank), input.dimension);
}

// The first number below `place`: "bodies"; below "" everywhere.
Unit of_keys(std::span<config::InputValue const> inputs, Dimension dimension, std::string_view place) {
    for (auto const& input : inputs) {
        if (input.dimension == dimension && input.key.starts_with(place)) {
            if (auto unit = unit_of(input)) {
                return unit;
            }
        }
    }
    return std::nullopt;
}

Unit of_levels(LevelSpec const& levels, Dimension dimension) {
    return levels.dimension() == dimension ? unit_named(levels.stated_unit, dimension) : std::nullopt;
}

Unit of_limits(CampaignSpec const& spec, Dimension dimension) {
    auto const found = std::ranges::find_if(spec.limits, [&](LimitState const& limit) {
        return !limit.shown.symbol.empty() && limit.quantity.units == si_symbol(dimension);
    });
    return found == spec.limits.end() ? std::nullopt : unit_named(found->shown.symbol, dimension);
}

// A target spectrum states the unit of its points by a key of its own.
Unit of_target(CampaignSpec const& spec, Dimension dimension) {
    for (auto const& input : spec.inputs) {
        if (input.key.starts_with("waves.") && input.key.ends_with(".unit")) {
            if (auto unit = unit_named(input.text, dimension)) {
                return unit;
            }
        }
    }
    return std::nullopt;
}

// Of slips, where distances have this unit.
Unit of_slip(Unit const& distance) {
    if (!distance || distance->symbol == "m" || distance->symbol == "km") {
        return std::nullopt;
    }
    return distance->symbol == "ft" ? unit_named("in", Dimension::length) : distance;
}

// Feet and inches are their own system: there nobody reads m/s.
Unit velocity_beside(Unit const& length) {
    return length && (length->symbol == "ft" || length->symbol == "in")
               ? unit_named(length->symbol + "/s", Dimension::velocity)
               : std::nullopt;
}

Unit first_of(std::initializer_list<Source> sources) {
    for (auto const& source : sources) {
        if (auto unit = source()) {
            return unit;
        }
    }
    return std::nullopt;
}

// \param typed the unit of a dimension; empty: nobody typed one \param bodies that of their lengths
template <class Typed> TypedUnits units_by(Typed const& typed, Unit const& bodies) {
    TypedUnits units;
    units.mass = typed(Dimension::mass).value_or(units.mass);
    units.length = bodies.value_or(units.length);
    units.acceleration = typed(Dimension::acceleration).value_or(units.acceleration);
    units.velocity = typed(Dimension::velocity).value_or(units.velocity);
    units.pressure = typed(Dimension::pressure).value_or(units.pressure);
    units.slip = of_slip(typed(Dimension::length)).value_or(units.slip);
    return units;
}

}  // namespace

std::optional<IntensityUnit> unit_named(std::string_view written, Dimension dimension) {
    auto symbol = std::string(trimmed(written));
    auto const usual = ", " + accepted_units(dimension) + ",";
    if (usual.find(", " + symbol + ",") == std::string::npos) {
        std::ranges::transform(symbol, symbol.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    }
    return symbol.empty() || usual.find(", " + symbol + ",") == std::string::npos
               ? std::nullopt
               : std::optional<IntensityUnit>({symbol, unit_factor(symbol, dimension)});
}

std::optional<IntensityUnit> typed_unit(CampaignSpec const& spec, Dimension dimension) {
    return first_of({[&] { return of_levels(spec.levels, dimension); }, [&] { return of_limits(spec, dimension); },
                     [&] { return of_keys(spec.inputs, dimension, dimension == Dimension::length ? "site" : ""); },
                     [&] { return of_keys(spec.inputs, dimension, "bodies"); },
                     [&] { return of_target(spec, dimension); },
                     [&] { return of_keys(spec.inputs, dimension, "waves.target"); },
                     [&] {
                         return dimension == Dimension::velocity
                                    ? velocity_beside(of_keys(spec.inputs, Dimension::length, "bodies"))
                                    : Unit();
                     }});
}

std::optional<IntensityUnit> unit_of_columns(CampaignSpec const& spec, Dimension dimension) {
    auto const unit = typed_unit(spec, dimension);
    return unit && unit->symbol == "ft" ? of_slip(unit) : unit;
}

TypedUnits typed_units(CampaignSpec const& spec) {
    return units_by([&](Dimension dimension) { return typed_unit(spec, dimension); },
                    of_keys(spec.inputs, Dimension::length, "bodies"));
}

TypedUnits typed_units(std::span<config::InputValue const> inputs) {
    auto const lengths = of_keys(inputs, Dimension::length, "");
    return units_by(
        [&](Dimension dimension) {
            return first_of({[&] { return of_keys(inputs, dimension, ""); },
                             [&] { return dimension == Dimension::velocity ? velocity_beside(lengths) : Unit(); }});
        },
        lengths);
}

MotionUnits motion_units(TypedUnits const& units) { return {units.velocity.symbol, units.length.symbol}; }

IntensityUnit shown_unit(TypedUnits const& units, std::string const& stored) {
    return stored == "m"      ? units.slip
           : stored == "m/s"  ? units.velocity
           : stored == "m/s2" ? units.acceleration
           : stored == "rad"  ? *unit_named("deg", Dimension::angle)
                              : IntensityUnit{stored};
}

IntensityUnit shown_unit(CampaignSpec const& spec, std::string const& stored) {
    return shown_unit(typed_units(spec), stored);
}

}  // namespace overturn
