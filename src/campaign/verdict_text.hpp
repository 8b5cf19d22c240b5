/// Verdicts in words, with the thresholds of movement that tell them apart.
#pragma once

#include <string>

#include "campaign/campaign_spec.hpp"
#include "model/verdict.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// "slid less than 1 mm, and no edge of its base rose 1 mm": the meaning of a verdict. \param length unit of
/// thresholds; defaults are in mm
[[nodiscard]] std::string verdict_text(VerdictEntry const& verdict, MovementSpec const& movement,
                                       IntensityUnit const& length);

/// " (slid less than 1 mm, and ...)" behind the name of the verdict of a body that moved, yet is called at rest; else
/// empty.
[[nodiscard]] std::string at_rest_text(Response const& response, MovementSpec const& movement,
                                       IntensityUnit const& length);

}  // namespace overturn
