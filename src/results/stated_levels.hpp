/// In which unit a results file's campaign states its levels.
#pragma once

#include <optional>
#include <string>

#include "store/results_file.hpp"

namespace overturn {

struct StatedUnit {
    std::string symbol;  ///< "gal"
    double si = 1;       ///< SI value of one of it
};

/// Empty where the campaign states them as bare numbers, or cannot be read by this program: its numbers are SI then.
[[nodiscard]] std::optional<StatedUnit> stated_unit_of_levels(store::ResultsReader const& file);

}  // namespace overturn
