/// Potential energy of the block, and its limits: where it turns back, and where it uplifts.
#pragma once

#include <cmath>

#include "rocking/rocking_accuracy.hpp"

namespace overturn::rocking {

/// Potential energy of the block over m g R: of the block as it is, or linearised (Housner 1963: psi for sin psi, 1 for
/// cos psi).
class Potential {
  public:
    Potential(Restoring restoring, double alpha) : linear_(restoring == Restoring::linear), alpha_(alpha) {}

    /// A/Gv beyond which it uplifts: tan(alpha).
    [[nodiscard]] double uplift_ratio() const { return linear_ ? alpha_ : std::tan(alpha_); }
    /// cos(alpha - phi) - cos(alpha), as a product that loses no digits.
    [[nodiscard]] double at(double phi) const {
        return linear_ ? phi * (alpha_ - 0.5 * phi) : 2 * std::sin(alpha_ - 0.5 * phi) * std::sin(0.5 * phi);
    }
    /// At phi = alpha: 1 - cos(alpha).
    [[nodiscard]] double top() const {
        double const s = std::sin(0.5 * alpha_);
        return linear_ ? 0.5 * alpha_ * alpha_ : 2 * s * s;
    }
    /// The rotation at which a block of energy `e` < top turns back.
    [[nodiscard]] double turning_point(double e) const {
        if (linear_) {
            return alpha_ - std::sqrt(std::fmax(0.0, alpha_ * alpha_ - 2 * e));
        }
        double const s = std::sqrt(std::fmax(0.0, 0.5 * (top() - e)));  // sin((alpha - phi)/2)
        return alpha_ - 2 * std::asin(std::fmin(1.0, s));
    }

  private:
    bool linear_;
    double alpha_;
};

}  // namespace overturn::rocking
