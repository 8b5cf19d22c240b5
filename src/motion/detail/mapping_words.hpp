/// Names of columns and directions in a line of prose, and what else stands between them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "motion/component_name.hpp"

namespace overturn {

struct MappingToken {
    enum class Kind { column, direction } kind = Kind::column;
    std::size_t column = 0;
    ComponentName component = {};  ///< of a column too, if it is called as a direction is: "z"
    bool joined = false;           ///< by an equals sign, a colon or a bracket to what stands before it
};

/// Between commas, semicolons and bars.
struct MappingClause {
    std::vector<MappingToken> tokens;
    bool wordy = false;  ///< do words that are not known stand among them?
};

/// Names of a column in prose: its name without its unit, the letter of its axis, "ch2", "col3" by its place.
[[nodiscard]] std::vector<std::string> aliases_of(std::string_view name, std::size_t place);

/// "x", "acc_y (gal)", "aw", "ch1", "a2": a letter or a number of no compass, that text may give any component?
[[nodiscard]] bool is_axis_name(std::string_view name);

/// The directions that a line lists, letters among them if it holds nothing else: "order: UD, NS, EW", "Z N E".
[[nodiscard]] std::vector<std::string> listed_directions(std::string_view line);

/// \param aliases of each column; none of those that are no motions
[[nodiscard]] std::vector<MappingClause> mapping_clauses(std::string_view line,
                                                         std::vector<std::vector<std::string>> const& aliases);

}  // namespace overturn
