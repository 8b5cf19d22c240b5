/// The answer that a campaign is run for: how each body does at the design basis and beyond.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "output/table.hpp"
#include "results/analysis.hpp"
#include "results/hazard_frequency.hpp"
#include "results/rare_rows.hpp"
#include "results/statistics.hpp"

namespace overturn::output {

/// Levels that the answer is given at: the design basis and named levels beyond it, six at most; where they are fewer
/// than three, the highest and a middle one. Without a named level: the lowest, a middle one and the highest. Places,
/// rising.
[[nodiscard]] std::vector<std::size_t> answer_levels(LevelSpec const& levels);

/// Error of P(overturn) by the accuracy of the settings, mean over bodies and levels, as `cost` found it.
struct NumericalError {
    double error = 0;
    bool is_bound = false;    ///< no verdict changed: it is not above this
    std::int64_t trials = 0;  ///< that it compared
};

/// Input of the answer; all outlive it.
struct Answered {
    CampaignSpec const& spec;
    Statistics const& statistics;
    std::span<BodyAnalysis const> analysis;
    double confidence = 0.95;
    std::span<BodyFrequency const> frequencies = {};  ///< where there is a hazard curve
    bool beta_u_of_campaign = true;                   ///< else of an option
    std::optional<NumericalError> numerical = {};     ///< where a record of `cost` was given
    std::span<RareBody const> rare = {};              ///< estimates of [rare], which stand in place of counts
};

/// The answer as people read it: rows of P of overturning and of every limit state with its interval, median and 95th
/// percentile of slip and tilt, HCLPF, annual frequency.
struct AnswerSheet {
    std::string title;              ///< number of waves, confidence of intervals
    std::vector<std::string> head;  ///< the levels' measure, nothing, and a level for each further column
    /// Body, what, and a cell for each level; or one cell for all (HCLPF). A row without a body is of the one above.
    std::vector<std::vector<std::string>> rows;
    std::string left_out;    ///< rows that were left out, and their place; empty: none
    std::string dependence;  ///< conditions of the numbers
};
/// Empty where waves are points of a grid, which are no sample. \param most_rows where bodies are many, rows are
/// left out \param parts in which the levels are shown one below the other: each repeats the rows
[[nodiscard]] AnswerSheet answer_sheet(Answered const& of, std::size_t most_rows, std::size_t parts = 1);

/// The same for the terminal: at most 15 lines of at most 100 columns, then cautions and what the numbers depend on.
[[nodiscard]] std::string answer_text(Answered const& of);

/// The same in SI: a row for each body, limit state and level.
[[nodiscard]] Table answer_table(Answered const& of);

/// "1 record: no probability, which needs 5 or more": empty where there are enough, or waves are drawn.
[[nodiscard]] std::string no_probability_text(Answered const& of);

/// "< 0.0092 (0 of 400)", "0.11 [0.0838, 0.145]", "not known". Ends of the interval are rounded outwards.
[[nodiscard]] std::string probability_text(Stripe const& stripe, double confidence);

}  // namespace overturn::output
