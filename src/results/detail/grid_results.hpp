/// The map of a grid of frequencies in the results file.
#pragma once

#include "results/analysis.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// /grid/<body>: per frequency the least level that lifts it off, overturns it, or passes a limit of the user's own,
/// the highest at which it stood, and how many tell nothing. \pre waves are a grid
void write_grid(store::ResultsWriter& file, CampaignSpec const& spec, BodyAnalysis const& body);

}  // namespace overturn
