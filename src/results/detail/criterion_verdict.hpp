/// What the counts and the curves of a body say for the energy criterion and against it.
#pragma once

#include "results/analysis.hpp"

namespace overturn {

/// \param body with its criterion and curves
[[nodiscard]] CriterionVerdict verdict_on(BodyAnalysis const& body, double confidence);

}  // namespace overturn
