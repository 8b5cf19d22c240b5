/// Probit regression on several columns, where only waves are independent of each other.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stats/bootstrap.hpp"

namespace overturn {

/// P = Phi(columns . coefficients) of each row.
struct ProbitDesign {
    Eigen::MatrixXd columns;
    std::vector<bool> overturned;     ///< of each row
    std::vector<std::int64_t> waves;  ///< of each row
};

/// Score of one wave's trials at the maximum: the gradient of their log-likelihood, and its negative curvature.
struct WaveScore {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd information;
};

struct ProbitRegression {
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd covariance;  ///< inverse information around the scatter of the waves' gradients (sandwich)
    double log_likelihood = 0;
    std::vector<WaveScore> waves;  ///< in the order of their numbers

    /// The coefficients with wave i counted times[i] times: one Newton step from the maximum with the reweighted
    /// gradient and information, off by O(1/waves) from the reweighted maximum (Davison & Hinkley 1997, 7.2). Nothing
    /// if what is left has no information.
    [[nodiscard]] std::optional<Eigen::VectorXd> reweighted(std::vector<double> const& times) const;
};

/// Newton's method on the concave log-likelihood (Pratt 1981). Nothing if it has no maximum: all ended the same way, or
/// outcomes are separated.
[[nodiscard]] std::optional<ProbitRegression> regress(ProbitDesign const& design);

/// Number of times that replicate `r` draws each of `waves` waves: as bootstrap_waves does, in the order of their
/// numbers.
[[nodiscard]] std::vector<double> times_drawn(BootstrapKey const& key, int r, std::size_t waves);

}  // namespace overturn
