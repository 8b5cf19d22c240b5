/// The lognormal fragility P = Phi((ln x - ln median) / beta) fitted by maximum likelihood: probit regression in ln x
/// (Finney 1947; Baker 2015, Earthquake Spectra 31(1), eq. 11, maximises the same binomial likelihood).
#pragma once

#include <optional>
#include <span>

#include "stats/fragility_data.hpp"

namespace overturn {

/// z = intercept + slope ln x, P = Phi(z).
struct ProbitLine {
    double intercept = 0;
    double slope = 0;  ///< 1 / beta

    [[nodiscard]] double log_median() const { return -intercept / slope; }
    [[nodiscard]] double beta() const { return 1 / slope; }
    [[nodiscard]] double at(double log_intensity) const { return intercept + slope * log_intensity; }
};

/// Log-likelihood of one point at the normal score z: k ln Phi(z) + (n - k) ln Phi(-z), and its derivative by z.
[[nodiscard]] double log_likelihood(FragilityPoint const& point, double z);
[[nodiscard]] double score(FragilityPoint const& point, double z);

/// The score, and how fast it falls with z: never negative, since the likelihood is concave (Pratt 1981).
struct ScoreSlope {
    double score = 0, fall = 0;
};
[[nodiscard]] ScoreSlope score_slope(FragilityPoint const& point, double z);

/// Without the binomial coefficients, which do not depend on the curve.
[[nodiscard]] double log_likelihood(std::span<FragilityPoint const> points, ProbitLine const& line);

/// The maximum, whatever the sign of its slope, by Newton's method. Empty if it did not converge.
/// \pre the outcomes overlap: state_of(points) is fitted
[[nodiscard]] std::optional<ProbitLine> fit_probit(std::span<FragilityPoint const> points);
/// The same, from a line near by: of data of which these were drawn.
[[nodiscard]] std::optional<ProbitLine> fit_probit(std::span<FragilityPoint const> points, ProbitLine const& begin);

/// The maximum of the likelihood times Jeffreys' prior, the root of the information's determinant: Firth's (1993)
/// penalty, finite for a probit even where outcomes are separated (Kosmidis & Firth 2021, Biometrika 108(1)).
/// Empty if the simplex did not converge. \pre at least two distinct intensities
[[nodiscard]] std::optional<ProbitLine> fit_penalised(std::span<FragilityPoint const> points);

}  // namespace overturn
