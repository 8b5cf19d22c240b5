/// Fragility curves as tables: the curve, P at multiples of the design basis, its band, the isotonic estimate, and what
/// drawn quantities do to the median.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "output/table.hpp"
#include "results/analysis.hpp"

namespace overturn::output {

/// Whose curves they are.
struct CurvesOf {
    std::string body;  ///< empty: of a table without a campaign
    std::string limit = overturning_limit;
    double confidence = 0.95;
};

/// "overturned", or what passing another limit state is called: "exceeded".
[[nodiscard]] std::string passed_name(Passing passing);

/// `fragility`, a row per measure. \pre fits of one limit state
[[nodiscard]] Table curve_table(CurvesOf const& of, std::span<MeasuredFragility const> fits);
/// All of them: `fragility`, `probabilities`, `band`, `isotonic`, `drawn`.
[[nodiscard]] std::vector<Table> curve_tables(CurvesOf const& of, std::span<MeasuredFragility const> fits);

}  // namespace overturn::output
