/// Is every word of a line of prose known, so that what it says of all numbers is a statement?
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace overturn {

/// Content of the clauses of a line that name a unit.
struct UnitClauses {
    bool any = false;           ///< does a clause name a unit of the dimension?
    bool plain = true;          ///< are these words of units, quantities, components, steps and fillings alone?
    bool denied = false;        ///< by another unit, or a word such as "not", "converted" or "noise"
    std::vector<double> units;  ///< different ones, in SI, in all clauses
    std::string name = {};      ///< of the first one, as it is written
};

/// "acceleration in gal, EW" is plain, "resolution in gal", "gal = column x 981" and "not in gal" are not. A letter
/// "g" counts as a unit. \param lower a line in lower case
[[nodiscard]] UnitClauses unit_clauses(std::string_view lower, Dimension dimension);

/// A title of any words with a unit, as "Kobe NS (g)" above a count and a step: is there none that denies it?
[[nodiscard]] bool is_title_of_unit(std::string_view lower, Dimension dimension);

/// Are all words of the line known ones, whatever they say: "absolute acceleration response spectrum"?
[[nodiscard]] bool is_of_known_words(std::string_view lower);

}  // namespace overturn
