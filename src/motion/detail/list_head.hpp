/// The line right above a list of values: its name, or a count and a time step.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/record.hpp"
#include "motion/text_table.hpp"

namespace overturn {

/// Fewer values to a line, without names, are columns, unless the format is stated.
inline constexpr std::size_t fewest_to_a_line = 5;

/// A line of two numbers right above a list, or above times and values; empty if there is none.
[[nodiscard]] std::vector<double> pair_above(TextTable const& table);

/// "1500 0.0100" in that line: the time step of as many values. [s]
/// \throws InputError if the line says another count, or no step
[[nodiscard]] std::optional<double> step_beside_count(TextTable const& table, std::string const& file);

/// \throws InputError if a count and a step stand above times that rise by another
void check_pair_above(TextTable const& table, double step_s, std::string const& file);

/// \throws InputError if the word right above one column names no acceleration: "velocity", "index", "d"
void check_name_of_list(TextTable const& table, std::string const& file);

/// \throws InputError if the first values are the count of those behind them or the stated time step, as some programs
/// write them above their values
void check_first_of_list(TextTable const& table, RecordRequest const& request);

}  // namespace overturn
