/// Intervals of a lognormal curve as if every wave had shown its capacity exactly. Trials of so many waves, each run at
/// all levels, hold no more than that.
#pragma once

#include <cstdint>

#include "stats/fragility.hpp"

namespace overturn {

/// Normal theory of n logarithms: Student's t for the median, chi-squared for beta; for a percentile and for P the
/// normal approximation of its tolerance bound (Natrella 1963, Experimental Statistics, NBS Handbook 91, section 2-13),
/// which errs to the long side of few.
class FewCapacities {
  public:
    /// \param line fitted by maximum likelihood \param waves 2 or more
    FewCapacities(ProbitLine const& line, std::int64_t waves, double confidence);

    [[nodiscard]] Interval median() const;
    [[nodiscard]] Interval beta() const;
    /// Of the intensity at which P is `probability`. Open towards the tail where so few say nothing of it.
    [[nodiscard]] Interval intensity(double probability) const;
    [[nodiscard]] Interval probability(double intensity) const;

  private:
    double mean_, deviation_;  // of ln capacity; the deviation without the bias of maximum likelihood
    double n_, confidence_, z_;
};

}  // namespace overturn
