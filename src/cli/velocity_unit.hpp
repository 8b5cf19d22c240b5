/// In which unit figures and tables show velocities; in JSON they are SI.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/typed_units.hpp"
#include "cli/command_line.hpp"
#include "output/shown_velocity.hpp"

namespace overturn::cli {

/// The unit that the user requests, else that of the campaign, else m/s.
struct VelocityUnit {
    std::optional<std::string> requested = {};  ///< by --velocities

    void offered_by(Verb& verb) {
        verb.takes("--velocities", requested,
                   "unit of velocities in figures and tables: kine or m/s; default: that of the campaign or body",
                   "UNIT");
    }
    /// \throws InputError where what was requested is no unit of velocity
    void check() const { (void)alone().si(); }
    /// Without a campaign.
    [[nodiscard]] output::ShownVelocity alone() const { return {requested.value_or(output::ShownVelocity::usual)}; }
    /// Where a body's file, or a record, states units.
    [[nodiscard]] output::ShownVelocity beside(TypedUnits const& units) const {
        return {requested.value_or(units.velocity.symbol)};
    }
    [[nodiscard]] output::ShownVelocity of_campaign(CampaignSpec const& spec) const {
        return beside(typed_units(spec));
    }
    /// Unit of measures in a table; empty where none was requested.
    [[nodiscard]] std::optional<IntensityUnit> measures() const {
        check();
        return requested ? IntensityUnit{*requested, alone().si()} : std::optional<IntensityUnit>();
    }
};

/// The value `units` for the scripts that draw figures and pages: the unit of each kind of quantity.
[[nodiscard]] inline nlohmann::ordered_json units_json(CampaignSpec const& spec, VelocityUnit const& velocity) {
    auto const units = typed_units(spec);
    auto const json = [](IntensityUnit const& unit) {
        return nlohmann::ordered_json{{"symbol", unit.symbol}, {"si", unit.si}};
    };
    return {{"mass", json(units.mass)},
            {"length", json(units.length)},
            {"slip", json(units.slip)},
            {"acceleration", json(units.acceleration)},
            {"velocity", velocity.of_campaign(spec).json()}};
}

}  // namespace overturn::cli
