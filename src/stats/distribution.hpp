/// A quantity that is not known exactly: fixed, normal, lognormal or uniform, truncated where it must be.
#pragma once

#include <limits>

namespace overturn {

/// Drawn by the inverse of its distribution function, so that one uniform number in (0, 1) makes one draw, whichever
/// way those numbers were sampled. Immutable and valid once made; every draw is finite.
class Distribution {
  public:
    /// \throws InputError unless the value is finite
    [[nodiscard]] static Distribution fixed(double value);
    /// \throws InputError unless both are finite and deviation >= 0
    [[nodiscard]] static Distribution normal(double mean, double deviation);
    /// ln x is normal about ln median with standard deviation beta. \throws InputError unless median > 0, beta >= 0
    [[nodiscard]] static Distribution lognormal(double median, double beta);
    /// \throws InputError unless low <= high, both finite
    [[nodiscard]] static Distribution uniform(double low, double high);

    /// The same, on condition that low <= x <= high.
    /// \throws InputError if the bounds hold less than 1 % of it: it is then not the distribution that was meant
    [[nodiscard]] Distribution truncated(double low, double high) const;

    /// The value below which a share u of the draws lies. \pre 0 < u < 1
    [[nodiscard]] double quantile(double u) const;
    /// The standard normal deviate that lies as far out as `value` does: what a draw says of its luck.
    /// \pre lowest() <= value <= highest()
    [[nodiscard]] double score(double value) const;

    /// The value stated: mean, median or middle, before truncation.
    [[nodiscard]] double centre() const;
    /// The extremes of all possible draws (u = 2^-53 and 1 - 2^-53).
    [[nodiscard]] double lowest() const;
    [[nodiscard]] double highest() const;
    /// False if every draw is the same.
    [[nodiscard]] bool scatters() const { return spread_ > 0; }

  private:
    enum class Shape { normal, lognormal, uniform };
    Distribution(Shape shape, double centre, double spread) : shape_(shape), centre_(centre), spread_(spread) {}
    [[nodiscard]] double share_below(double value) const;

    Shape shape_;
    double centre_;  ///< mean, ln median, middle
    double spread_;  ///< standard deviation, beta, half width
    double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
    double share_low_ = 0, share_high_ = 1;  ///< of the untruncated distribution below the bounds
};

}  // namespace overturn
