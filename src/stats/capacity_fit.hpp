/// The lognormal fragility of capacities: the intensity at which each wave's body fell, found by incremental analysis.
#pragma once

#include <optional>
#include <span>

#include "stats/fragility.hpp"

namespace overturn {

/// Capacity found under one wave.
struct Capacity {
    double intensity = 0;  ///< at which it fell; the highest that was tried, where it did not
    bool reached = true;   ///< false: censored, it stood up to there
};

/// ln median = mean of ln capacity, beta = its standard deviation over n - 1 (Baker 2015, Earthquake Spectra 31(1), eqs
/// 2 and 3). Nothing where a capacity is censored, or of fewer than five.
struct CapacityMoments {
    double median = 0, beta = 0;
};
[[nodiscard]] std::optional<CapacityMoments> moments_of(std::span<Capacity const> capacities);

/// Maximum likelihood: densities of what was reached, upper tails of what was not (Baker 2015, eq. 7; Cohen 1959), by
/// Newton's method in (ln median / beta, 1 / beta), in which it is concave (Olsen 1978, Econometrica 46(5)). Nothing
/// unless two different capacities were reached, or if it does not converge.
[[nodiscard]] std::optional<ProbitLine> fit_capacities(std::span<Capacity const> capacities);

/// The log likelihood, and where a likelihood-ratio test of this confidence ends: of the intensity at which P is
/// `probability`, and of beta. \param best fit_capacities of the same
[[nodiscard]] double log_likelihood(std::span<Capacity const> capacities, ProbitLine const& line);
[[nodiscard]] Interval profile_intensity(std::span<Capacity const> capacities, ProbitLine const& best,
                                         double probability, double confidence);
[[nodiscard]] Interval profile_beta(std::span<Capacity const> capacities, ProbitLine const& best, double confidence);

/// Stripes of the capacities: all waves tried at every capacity that was reached, those censored below it undecided.
[[nodiscard]] std::vector<Stripe> stripes_of(std::span<Capacity const> capacities);

/// All of it as a fragility: the curve with profile intervals and refits to resampled waves; where there is no curve,
/// what the stripes hold. Request: confidence, beta_u, bootstrap. \pre capacities is not empty
[[nodiscard]] FragilityFit fragility_of(std::span<Capacity const> capacities, FragilityRequest const& request);

}  // namespace overturn
