/// Verdict on the energy criterion from a body's counts and curves.
#pragma once

#include "results/analysis.hpp"

namespace overturn {

/// \param body with its criterion and curves
[[nodiscard]] CriterionVerdict verdict_on(BodyAnalysis const& body, double confidence);

}  // namespace overturn
