/// Profile-likelihood intervals of a fitted lognormal fragility: the values that a likelihood-ratio test of the given
/// confidence does not reject (Venzon & Moolgavkar 1988, Applied Statistics 37(1)). Every trial counts as independent.
#pragma once

#include <span>

#include "stats/probit.hpp"

namespace overturn {

class ProfileLikelihood {
  public:
    /// \param best the maximum, its slope above 0
    ProfileLikelihood(std::span<FragilityPoint const> points, ProbitLine const& best, double confidence);

    /// Does a curve without slope fit so much worse that the rise is beyond chance? If not, beta has no upper end.
    [[nodiscard]] bool rises() const { return rises_; }
    /// Interval of the lognormal standard deviation; the upper end may be infinite.
    [[nodiscard]] Interval beta() const;
    /// Interval of the intensity at which P is `probability`, 0.5 for the median; the ends may be 0 and infinite.
    [[nodiscard]] Interval intensity(double probability) const;
    /// Interval of P at an intensity.
    [[nodiscard]] Interval probability(double intensity) const;

  private:
    // z = offset + s direction along a line of curves, both linear in ln x.
    struct Family {
        ProbitLine offset, direction;
    };
    enum class Sign { any, not_negative };
    [[nodiscard]] double best_of(Family const& family, Sign sign, double guess) const;
    [[nodiscard]] double deviance(double log_likelihood) const { return 2 * (best_likelihood_ - log_likelihood); }
    template <class Profile> [[nodiscard]] double end(Profile const& profile, double from, double step) const;
    [[nodiscard]] double flat_deviance(double probability) const;

    std::span<FragilityPoint const> points_;
    ProbitLine best_;
    double best_likelihood_, allowed_, mean_;
    bool rises_;
};

}  // namespace overturn
