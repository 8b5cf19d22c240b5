/// Names of the states and flags of a fit, in results files, JSON and texts.
#pragma once

#include <string>
#include <vector>

#include "stats/fragility.hpp"

namespace overturn::output {

/// "fitted", "nothing-overturned" ("nothing-exceeded"), ...
[[nodiscard]] std::string name_of(FragilityState state, Passing passing = Passing::overturned);
/// All of them.
[[nodiscard]] std::vector<std::string> names_of_states(Passing passing);
/// The state for people: "nothing overturned", "levels too far apart".
[[nodiscard]] std::string state_words(FragilityFit const& fit);
/// Names of the flags that are set.
[[nodiscard]] std::vector<std::string> names_of(FragilityFlags flags, Passing passing = Passing::overturned);

}  // namespace overturn::output
