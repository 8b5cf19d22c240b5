/// Sentences of a report's page, as its data: the page itself holds headings and labels alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/answer.hpp"
#include "output/json.hpp"

namespace overturn::output {

/// A line for each body and limit state below the answer: the design basis, the curve, how often in a year. Of waves on
/// a grid: from which level on, at how many frequencies.
[[nodiscard]] std::vector<std::string> headlines(Answered const& of);

/// Remarks beside the rows of `probabilities`, in their order: {body, limit, measure, text}.
[[nodiscard]] Json quote_remarks(Answered const& of);

/// Low points of the curves, the safe end first, in the order of `fragility`: {body, limit, measure,
/// five_percent_point, hclpf}, each as text.
[[nodiscard]] Json low_points(Answered const& of);

/// Number of trials that still rocked when the record ended, a line for each body with such trials.
[[nodiscard]] std::vector<std::string> cut_short_lines(Answered const& of);

/// Notes on tables and figures, by name; those with {places} are filled in with the numbers that the page computes.
[[nodiscard]] Json page_notes(Answered const& of);

/// The lines on how long the campaign took. \param place the file that says so
[[nodiscard]] std::string cost_text(double wall_s, std::int64_t ranks, std::size_t runs, double trials_per_s,
                                    std::string const& place);

/// "12 of 15 tests that fell though their trial stood, ..."
[[nodiscard]] std::string false_safe_histories_text(std::size_t shown, std::size_t all);

/// The title of a drawn wave. \param telling it overturned a body at the lowest level at which any did
[[nodiscard]] std::string wave_title(std::int64_t number, bool telling);

/// Number of bodies whose histories are drawn, where it is not all of them, and the bodies that did not move at the
/// design basis, so that no history of it is drawn. Empty where there is neither.
[[nodiscard]] std::string histories_text(std::size_t shown, std::size_t bodies,
                                         std::vector<std::string> const& at_rest_at_design_basis);

/// That figures show the trials of the first waves alone.
[[nodiscard]] std::string shown_waves_text(std::int64_t shown, std::int64_t all);

/// "40"; "32 of 64 planned: it ended early, precise enough".
[[nodiscard]] std::string ran_text(std::int64_t ran, std::int64_t planned);

/// Above everything, where the file is not as it was written.
[[nodiscard]] std::string changed_file_text();

}  // namespace overturn::output
