/// Curves as rows of a results file.
#pragma once

#include <string>
#include <vector>

#include "results/analysis.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// One row per measure into `group`; numbers that are not identifiable are NaN. \pre fits of one limit state
void write_fragility(store::ResultsWriter& file, std::string const& group, std::vector<MeasuredFragility> const& fits,
                     double confidence);

/// How far stored curves are from the same fitted again.
struct RefitDifference {
    double relative = 0;  ///< the largest of all columns; infinite where one is known and the other is not
    std::string column;   ///< where: "fragility/type-a/median"
};
/// \param fits at the confidence that the file's were made at
[[nodiscard]] RefitDifference refit_difference(store::ResultsReader const& file, std::string const& group,
                                               std::vector<MeasuredFragility> const& fits);

}  // namespace overturn
