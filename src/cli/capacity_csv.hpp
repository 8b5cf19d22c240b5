/// Capacities found by incremental analysis, from a table: a row per wave.
#pragma once

#include <string>
#include <vector>

#include "stats/capacity_fit.hpp"

namespace overturn::cli {

struct CapacityTable {
    std::vector<Capacity> capacities;  ///< rising
    std::string column;                ///< as the header calls them, with their unit: "pga [g]"
    std::string measure, unit;         ///< that the name, or the text, states; empty: none
    std::vector<std::string> unread;   ///< lines of text that are not understood
};

/// A header with one column of intensities ("pga [g]", "IM", "capacity [g]") and, if wanted, one that says whether the
/// body fell there (`collapsed`: 1 or 0, yes or no); ">1.3" is short for "stood up to 1.3". A column `record`
/// names the waves. \param file for messages \throws InputError naming line and column, also of two rows of one
/// recording
[[nodiscard]] CapacityTable parse_capacities(std::string const& text, std::string const& file);

}  // namespace overturn::cli
