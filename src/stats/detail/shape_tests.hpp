/// Are the proportions those of a curve that rises, and of this one? Judged by what data of the curve would do.
#pragma once

#include <optional>

#include "stats/bootstrap.hpp"
#include "stats/fragility.hpp"

namespace overturn {

struct ShapeTests {
    MonotoneTest monotone;
    std::optional<GoodnessOfFit> goodness;  ///< of the line, where there is one
};

/// Both tests with their chances. Independent trials are drawn anew from the line (parametric bootstrap), from one P
/// throughout where there is none; what falls under the line by no chance is held against the rising estimate too. Chi
/// squared judges the deviance where at most twenty groups expect five or more to fall and to stand. Where trials share
/// waves, waves are drawn anew with all their trials, about what the null hypothesis says of the data (Davison &
/// Hinkley 1997, 4.4). Drawing stops once a hundred were as far off (Besag & Clifford 1991), at the latest after 999:
/// no chance is reported below 1 in 1000. Draws come from the key's own streams.
/// \pre data.points is not empty
[[nodiscard]] ShapeTests test_shape(FragilityData const& data, std::optional<ProbitLine> const& line,
                                    BootstrapKey const& key);

}  // namespace overturn
