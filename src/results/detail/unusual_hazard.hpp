/// Hazard curves that are possible and hardly meant: rates that are none of a year, intensities in another unit.
#pragma once

#include <string>
#include <vector>

#include "results/hazard_table.hpp"
#include "stats/hazard.hpp"

namespace overturn {

/// A line each. \param measure in lower case: "pga", "sa(1 s)"
[[nodiscard]] std::vector<std::string> unusual_hazard(HazardCurve const& hazard, HazardAxis const& axis,
                                                      std::string const& measure);

}  // namespace overturn
