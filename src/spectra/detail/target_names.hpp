/// Names and text of a target's table, and their contradictions to its kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/pair_table.hpp"
#include "spectra/target_spectrum.hpp"

namespace overturn {

/// Do these name a target's columns: a period or a frequency, and an ordinate?
[[nodiscard]] bool are_target_names(std::string_view first, std::string_view second);

/// SI value of the frequencies' unit, if the first column holds frequencies [Hz]; nothing for periods.
/// \throws InputError if its name says neither, or a logarithm
[[nodiscard]] std::optional<double> frequency_unit(PairTable const& table, Location const& where);

/// Are the ordinates natural logarithms? \throws InputError at logarithms of another base
[[nodiscard]] bool are_logarithms(PairTable const& table, Location const& where);

/// Without "ln": "ln(Sa)" is "Sa".
[[nodiscard]] std::string ordinate_name(std::string_view name);

/// \throws InputError if the second name calls the values another quantity than `kind`: a velocity, a hazard curve, a
/// ratio, a standard deviation
void check_kind(PairTable const& table, TargetKind kind, Location const& where);

/// Kind of the ordinates that a name states, if it states one.
[[nodiscard]] std::optional<TargetKind> kind_named(std::string_view name);

/// The names and lines of text that are not understood. \throws InputError if one calls the values another quantity, or
/// states another damping
[[nodiscard]] std::vector<std::string> check_text(PairTable const& table, TargetKind kind, double damping,
                                                  std::string const& name);

/// The number that stands at the end, "10" of "h = 10 "; nothing if none does.
[[nodiscard]] std::optional<double> number_at_end(std::string_view text);

/// "5 percent", "5 per cent" and "5pct" are "5%".
[[nodiscard]] std::string with_percent_signs(std::string_view text);

/// "5 % damped", "h = 0.02", "damping ratio: 0.05"
[[nodiscard]] std::optional<double> damping_in(std::string_view lower);

}  // namespace overturn
