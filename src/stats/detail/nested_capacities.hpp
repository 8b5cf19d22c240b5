/// Intervals of a lognormal curve from waves that were each run at several levels. A wave tells no more than between
/// which of them its capacity lies: trials of one wave are nested, not independent.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stats/fragility_data.hpp"
#include "stats/probit.hpp"

namespace overturn {

/// So many waves have their capacity in a range of ln intensity, which may be open on either side.
struct CapacityRange {
    double low = 0, high = 0;
    double waves = 0;
};

/// Each wave's range: from the highest level below its first fall at which it stood, to that fall. Components of one
/// recording count as one wave together. \param trials decided ones, of which one wave may have several
[[nodiscard]] std::vector<CapacityRange> ranges_of(std::span<SingleTrial const> trials);
/// The same of counts, if all levels have the same `waves`: what they then hold at least. P is taken as rising.
[[nodiscard]] std::vector<CapacityRange> ranges_of(std::span<FragilityPoint const> points, double waves);

/// Profile likelihood of interval-censored capacities (Meeker and Escobar 1998, Statistical Methods for Reliability
/// Data, 8.3): where twice the log likelihood falls short of its maximum by more than chi-squared allows.
class NestedCapacities {
  public:
    /// \param near a curve through the same data, from which the best one is looked for \pre ranges hold a rise
    NestedCapacities(std::vector<CapacityRange> ranges, ProbitLine const& near, double confidence);

    [[nodiscard]] Interval median() const { return intensity(one_half); }
    /// Of the intensity at which P is `probability`; the ends may be 0 and infinite.
    [[nodiscard]] Interval intensity(double probability) const;
    [[nodiscard]] Interval beta() const;
    [[nodiscard]] Interval probability(double intensity) const;

  private:
    static constexpr double one_half = 0.5;

    [[nodiscard]] double log_likelihood(double log_median, double beta) const;
    /// The best of curves that pass the score z at the ln intensity x.
    [[nodiscard]] double best_through(double x, double z) const;
    [[nodiscard]] double best_of_beta(double beta) const;

    std::vector<CapacityRange> ranges_;
    double log_median_, log_beta_;  ///< of the best curve
    double least_ = 0;              ///< log likelihood at the ends
};

}  // namespace overturn
