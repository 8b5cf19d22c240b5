/// First column of a target's table, by its text: period or frequency.
#pragma once

#include <string>

#include "motion/pair_table.hpp"

namespace overturn {

/// \param frequencies is the first column one of them? \param period_unit_s what one unit of its periods is
/// \throws InputError at a line that says the other of "frequency in Hz" and "periods in s", or another unit
void check_axis_text(PairTable const& table, bool frequencies, double period_unit_s, std::string const& file);

}  // namespace overturn
