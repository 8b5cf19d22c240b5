/// Anybody's own stripes from a table: amplitude, trials, overturned.
#pragma once

#include <string>
#include <vector>

#include "stats/stripe.hpp"

namespace overturn::cli {

/// The stripes of a text parted by commas, semicolons or tabs, rising: a header naming amplitude, trials and overturned
/// (failed too, if there is such a column) in any order, then one row per stripe. Blank lines and what follows # do not
/// count. \param file for messages \throws InputError naming line and column
[[nodiscard]] std::vector<Stripe> parse_stripes(std::string const& text, std::string const& file);

}  // namespace overturn::cli
