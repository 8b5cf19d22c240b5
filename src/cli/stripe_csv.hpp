/// Anybody's own stripes from a table: amplitude, trials, overturned.
#pragma once

#include <string>
#include <vector>

#include "stats/fragility_data.hpp"
#include "stats/stripe.hpp"

namespace overturn::cli {

struct StripeTable {
    std::vector<Stripe> stripes;
    /// The same one by one where a column names their waves; two components of one recording count as one wave.
    std::vector<SingleTrial> trials;
    std::int64_t waves = 0;               ///< different ones of these
    std::string wave;                     ///< column that names the waves; empty: none
    std::string amplitude = "amplitude";  ///< as the header calls it, with its unit: "IM [g]"
    std::string measure;                  ///< "pga", "sa(1 s)"; empty: the header states none ("IM", "amplitude")
    std::string unit;                     ///< in the header's brackets, or the text's; empty: none
    std::vector<std::string> unread;      ///< lines of text that are not understood
};

/// The stripes of a text parted by commas, semicolons, tabs or blanks, rising: a header naming amplitude, trials and
/// overturned (failed too, if there is such a column) in any order, or their usual names elsewhere (IM, num_gms,
/// num_collapse), the amplitude with its unit in brackets, then one row per stripe. Without a column of trials each row
/// is one, with 1 (fell) or 0 (stood) under `collapsed`, `fell` or `overturned`; those of one amplitude are added up,
/// and a column `wave`, `record` or the like names what was shaken.
/// Prose above the header and what follows # may state the unit. \param file for messages \throws InputError naming
/// line and column
[[nodiscard]] StripeTable parse_stripes(std::string const& text, std::string const& file);

}  // namespace overturn::cli
