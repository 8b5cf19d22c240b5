/// The criterion "measure < limit: safe" on trial against time histories of the same waves.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stats/stripe.hpp"

namespace overturn {

/// One decided trial as the criterion saw it.
struct CriterionTrial {
    double ratio = 0;  ///< measure over limit
    std::int64_t wave = 0;
    bool overturned = false;
    bool uplifted = true;  ///< an edge of its base left the ground: otherwise it could not overturn

    [[nodiscard]] bool predicted_safe() const { return ratio < 1; }
};

/// A share with its exact interval.
struct Share {
    std::int64_t count = 0, of = 0;
    Interval interval;

    [[nodiscard]] double value() const { return static_cast<double>(count) / static_cast<double>(of); }
};
/// \param group_size so many of them share what was drawn, and count as one in the interval
[[nodiscard]] Share share_of(std::int64_t count, std::int64_t of, double confidence, double group_size = 1);

/// Quantiles of the ratio; empty if there was no trial of that kind.
struct RatioQuantiles {
    std::int64_t count = 0;
    double lowest = 0, p05 = 0, p25 = 0, median = 0, p75 = 0, p95 = 0, highest = 0;
};
/// A percentile that needs more independent values than there are is NaN (fewest_for_quantile). \param independent so
/// many of them; none: all \return nothing where there is none
[[nodiscard]] std::optional<RatioQuantiles> ratio_quantiles(std::vector<double> ratios,
                                                            std::optional<double> independent = {});

/// In intervals of shares of trials those of one wave count as one: they may all end alike (Kish 1965).
struct CriterionStudy {
    Confusion counts;
    Share safe_but_overturned;           ///< of all trials predicted safe: the share that must be 0
    Share safe_uplifted_but_overturned;  ///< of trials that uplifted: no other tests the criterion
    Share overturned_predicted_safe;     ///< of all trials that overturned
    Share unsafe_but_stood;              ///< of all trials predicted unsafe: the false alarms
    Share stood_predicted_unsafe;        ///< of all trials that stood
    /// Share of the waves with a trial predicted safe in which such a trial overturned. Trials of one wave are not
    /// independent, waves are.
    Share waves_safe_but_overturned;
    Share waves_safe_uplifted_but_overturned;         ///< the same for trials that uplifted
    std::optional<RatioQuantiles> at_overturning;     ///< all trials that overturned
    std::optional<RatioQuantiles> first_overturning;  ///< of each wave the lowest ratio that overturned
    std::optional<RatioQuantiles> highest_standing;   ///< of each wave the highest ratio that stood
};
/// \param group_size so many waves share what was drawn, and count as one in intervals
[[nodiscard]] CriterionStudy study_criterion(std::span<CriterionTrial const> trials, double confidence,
                                             double group_size = 1);

}  // namespace overturn
