/// One lognormal curve through trials, with the intervals of its numbers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stats/detail/few_capacities.hpp"
#include "stats/detail/profile_likelihood.hpp"
#include "stats/fragility.hpp"
#include "stats/scores.hpp"

namespace overturn {

struct CurveFit {
    ProbitLine line;
    ProfileLikelihood likelihood;  ///< of the points that were fitted, which outlive it
    Bootstrap refits;
    FragilityFit::Intervals profile, bootstrap;
    /// By so many exact capacities, where waves are few or not known.
    std::optional<FewCapacities> few = {};
    FragilityFit::Intervals of_few = {};
    double resampled_confidence = 0.95;  ///< at which resamples are read for the stated one (stats/bootstrap.hpp)

    [[nodiscard]] FragilityFit::Intervals ends(FragilityFit::Method method) const;
    [[nodiscard]] Interval probability(double intensity, FragilityFit::Method method) const;
};

/// Each interval becomes the hull of itself and the other; HCLPF stays unknown where it was.
void widen(FragilityFit::Intervals& to, FragilityFit::Intervals const& by);

struct CurveAttempt {
    FragilityState state = FragilityState::fitted;  ///< fitted, or why there is no curve
    std::optional<CurveFit> curve;
};

/// \param trials the same one by one, or none: every trial then counts as independent \param fewest_waves of them,
/// where there are none; 0: not known \pre they overlap (state_of)
[[nodiscard]] CurveAttempt fit_curve(std::span<FragilityPoint const> points, std::span<SingleTrial const> trials,
                                     std::int64_t fewest_waves, FragilityRequest const& request);

/// Results that hold whatever the undecided trials would have done.
struct UndecidedExtremes {
    /// The median is not reported: more than 5 % of a stripe (or tenth of the trials) at or below it has no verdict.
    bool hide_median = false;
    FragilityFit::Intervals ends;  ///< the hull of those of `decided`, of all undecided standing and of all fallen
    std::vector<std::vector<Replicate>> refits;  ///< of the bootstrap of either extreme; none where it holds no curve
};
[[nodiscard]] UndecidedExtremes weigh_undecided(FragilityData const& data, CurveFit const& decided,
                                                FragilityRequest const& request, FragilityFit::Method method);

}  // namespace overturn
