#include "results/stated_levels.hpp"

#include "campaign/level_spec.hpp"
#include "config/table.hpp"
#include "results/recount.hpp"

namespace overturn {

std::optional<StatedUnit> stated_unit_of_levels(store::ResultsReader const& file) {
    try {
        auto const input = input_of(file);
        auto const levels = read_levels(config::Table::parse(input.text, input.name, input.settings).child("levels"));
        return levels.stated_unit.empty() ? std::nullopt
                                          : std::optional(StatedUnit{levels.stated_unit, levels.stated_unit_si});
    } catch (InputError const&) {
        return std::nullopt;  // keys of another program
    }
}

}  // namespace overturn
