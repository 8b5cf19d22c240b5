#include "results/stated_levels.hpp"

#include "campaign/level_spec.hpp"
#include "campaign/typed_units.hpp"
#include "config/table.hpp"
#include "results/recount.hpp"

namespace overturn {

std::optional<IntensityUnit> stated_unit_of_levels(store::ResultsReader const& file) {
    try {
        auto const input = input_of(file);
        auto const levels = read_levels(config::Table::parse(input.text, input.name, input.settings).child("levels"));
        return levels.stated_unit.empty() ? std::nullopt
                                          : std::optional(IntensityUnit{levels.stated_unit, levels.stated_unit_si});
    } catch (InputError const&) {
        return std::nullopt;  // keys of another program
    }
}

std::map<std::string, IntensityUnit> stated_units_of_columns(CampaignSpec const& spec) {
    std::map<std::string, IntensityUnit> units;
    for (auto const dimension :
         {Dimension::length, Dimension::mass, Dimension::velocity, Dimension::acceleration, Dimension::angle}) {
        auto const si = std::string(si_symbol(dimension));
        if (auto const unit = unit_of_columns(spec, dimension); unit && unit->symbol != si) {
            units[si] = *unit;
        }
    }
    return units;
}

}  // namespace overturn
