/// The years that the text above a hazard curve speaks of: are its numbers exceedances of one year?
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/pair_table.hpp"

namespace overturn {

/// "50 years", "in 50 yr": the number of years; nothing where none is named.
[[nodiscard]] std::optional<double> named_years(std::string_view text);

/// "investigation_time = 50", "exposure time 50 a", "10 % probability of exceedance in 50 years", "PoE in 50 yr": the
/// years; 0 where it speaks of a probability or of an investigation time without them; nothing of all else.
[[nodiscard]] std::optional<double> years_in(std::string const& text);

/// Is a column's name that of a frequency in a year: "annual_exceedance", "MAFE", "annual rate [1/a]"?
[[nodiscard]] bool is_annual_frequency(std::string_view name);

/// \throws InputError unless the second column's name is one
void check_annual(PairTable const& table, Location const& where);

/// \return remarks on lines that only name some years \throws InputError at a line by which the numbers may be
/// probabilities in more years than one, or still have a factor or another span to them ("values x 100", "in 10^-4 per
/// year", "per century")
[[nodiscard]] std::vector<std::string> check_years(PairTable const& table, std::string const& name);

}  // namespace overturn
