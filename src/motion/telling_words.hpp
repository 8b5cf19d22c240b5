/// Words of a line that may change what the numbers below it are. Every function takes a line in lower case, but that
/// of a column's name.
#pragma once

#include <string>
#include <string_view>

namespace overturn {

/// "scaled by 0.5", "multiply by 9.81", "x 100", "divide by 980", "normalised", "relative to"
[[nodiscard]] bool tells_factor(std::string_view lower);

/// "50 % of the original", "percent of g"
[[nodiscard]] bool tells_share(std::string_view lower);

/// "VEL", "NS velocity", "raw counts", "displ.": of accelerations that a line does not call so
[[nodiscard]] bool tells_other_quantity(std::string_view lower);

/// "median", "84th percentile", "16 % fractile", "best estimate minus one sigma": which of several curves it is
[[nodiscard]] bool tells_statistic(std::string_view lower);

/// "Fourier", "FAS", "power spectral density": of nothing that an oscillator's response makes
[[nodiscard]] bool tells_no_response(std::string_view lower);

/// The same, "floor", "in-structure", "inelastic": of no response spectrum of the ground
[[nodiscard]] bool tells_other_spectrum(std::string_view lower);

/// Is there a word in a column's name, in any case, that may change what its numbers are: "Sa_vertical (g)", "SaZ",
/// "Sa84", "Sa_2pc", "Sa_floor", "pga_v"? Its unit is none.
[[nodiscard]] bool tells_more_in_name(std::string_view name);

/// "decimated by 2", "sign reversed", "pseudo-acceleration", "time in ms": of accelerations in a file of them
[[nodiscard]] bool tells_change(std::string_view lower);

/// Is there a word in the name of a record's column, in any case, that makes it none of a motion's own accelerations:
/// "acc error", "acc_std", "envelope", "-acc"?
[[nodiscard]] bool tells_other_values(std::string_view name);

/// "per century", "monthly": no rate of a year
[[nodiscard]] bool tells_other_span(std::string_view lower);

/// A figure that is no year, date or time of day, no magnitude or distance in km and no part of a name: "Fs=200", but
/// not "Kobe 1995", "M 6.9", "RSN1106"
[[nodiscard]] bool holds_open_figure(std::string_view lower);

/// "200 Hz", "200Hz"
[[nodiscard]] bool tells_rate(std::string_view lower);

/// "vertical", "UD", "up-down", "HNZ", as a word of its own
[[nodiscard]] bool tells_vertical(std::string_view lower);

/// The only component that a line names between its commas, if it is vertical: "station ABC, vertical", "HNZ", "up-down
/// component", a letter beside a unit, "m/s2, Z"; empty where it names none, another or several.
[[nodiscard]] std::string vertical_alone_in(std::string_view lower);

}  // namespace overturn
