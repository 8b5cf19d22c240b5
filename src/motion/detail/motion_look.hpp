/// Does a column look like a motion, like times or like a count? For numbers that nothing calls accelerations.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace overturn {

/// Reason why numbers are a time or a count, whatever their name.
inline constexpr std::string_view only_rising = "values that only rise or only fall";

/// Why it looks like none: it never changes its sign, only rises, or swings about another value than zero; empty if it
/// may be one. Less than 20 numbers are too few to judge.
[[nodiscard]] std::string_view no_motion(std::span<double const> values);

/// The same of numbers that are called accelerations: these may be a pulse, which keeps its sign but begins at zero,
/// and may swing about another value. \param own are they named as this program names what it writes? Then a ramp is
/// one.
[[nodiscard]] std::string_view no_named_motion(std::span<double const> values, bool own);

/// A value that many programs write where there is none, -999 or 9999, far above all others; the first row of it.
[[nodiscard]] std::optional<std::size_t> gap_in(std::span<double const> values);

/// Do the columns swing each on its own, so that a row is no part of one series?
[[nodiscard]] bool are_side_by_side(std::vector<std::vector<double>> const& columns);

/// Do they rise as times do: in equal steps, up to the rounding of printed numbers?
[[nodiscard]] bool rises_evenly(std::vector<double> const& values);

/// Each is one more than the one before.
[[nodiscard]] bool counts_rows(std::vector<double> const& values);

}  // namespace overturn
