/// One lognormal curve through trials, with the intervals of its numbers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stats/detail/few_capacities.hpp"
#include "stats/detail/nested_capacities.hpp"
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
    /// By the range of each wave's capacity, where waves have several trials.
    std::optional<NestedCapacities> nested = {};
    std::optional<FragilityFit::Intervals> of_capacities = {};  ///< the hull of both
    bool resampled = true;               ///< false: no stripe has two trials, so that resampling one changes nothing
    double resampled_confidence = 0.95;  ///< at which resamples are read for the stated one (stats/bootstrap.hpp)

    [[nodiscard]] FragilityFit::Intervals ends(FragilityFit::Method method) const;
    [[nodiscard]] Interval probability(double intensity, FragilityFit::Method method) const;
};

/// Are the ranges of waves' capacities among what the intervals are made of? Of levels they gather in few ranges, of a
/// measured intensity each wave has its own, so that many cost time. Balanced draws are no part of the error, which
/// they would count.
[[nodiscard]] bool is_nested(FragilityData const& data, FragilityRequest const& request, std::int64_t waves);

/// Each interval becomes the hull of itself and the other; HCLPF stays unknown where it was.
void widen(FragilityFit::Intervals& to, FragilityFit::Intervals const& by);

struct CurveAttempt {
    FragilityState state = FragilityState::fitted;  ///< fitted, or why there is no curve
    std::optional<CurveFit> curve;
};

/// \param data what is fitted to: its trials one by one, or none, where every trial counts as independent
/// \pre they overlap (state_of)
[[nodiscard]] CurveAttempt fit_curve(FragilityData const& data, FragilityRequest const& request);

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
