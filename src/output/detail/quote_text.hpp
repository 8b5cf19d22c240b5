/// P at one intensity, in words.
#pragma once

#include <string>

#include "results/analysis.hpp"

namespace overturn::output {

/// "  P at 2 x design basis, pga 1200 gal: 0.11 [0.04, 0.27], 3 of 40 trials there": a line.
[[nodiscard]] std::string quote_line(MeasuredFragility const& m, QuotedProbability const& q);

/// Remark beside P and its interval in a table: "3 of 40 trials there, in the tail". Empty: no remark.
[[nodiscard]] std::string quote_remark(MeasuredFragility const& m, QuotedProbability const& q);

/// "curves over measures other than pga depend on ..."
[[nodiscard]] std::string other_measures_text(std::string const& levels);

}  // namespace overturn::output
