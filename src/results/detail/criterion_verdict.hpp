/// What speaks for the energy criterion and against it.
#pragma once

#include "results/analysis.hpp"

namespace overturn {

[[nodiscard]] CriterionVerdict verdict_on(BodyAnalysis const& body, double confidence);

}  // namespace overturn
