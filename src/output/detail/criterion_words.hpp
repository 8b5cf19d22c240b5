/// Findings for and against the energy criterion, in sentences, each with its numbers.
#pragma once

#include <string>
#include <vector>

#include "results/analysis.hpp"

namespace overturn::output {

struct CriterionWords {
    std::vector<std::string> supports, against, open;
};
/// None where no energies were measured. \param confidence that of the analysis
[[nodiscard]] CriterionWords words_on(BodyAnalysis const& body, double confidence);

}  // namespace overturn::output
