/// A fragility over two intensity measures at once: does a second one add what the first lacks?
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stats/bootstrap.hpp"
#include "stats/proportion.hpp"

namespace overturn {

/// One decided trial with both of its measures.
struct TwoMeasureTrial {
    std::array<double, 2> log_intensity{};  ///< ln of the SI values
    bool overturned = false;
    std::int64_t wave = 0;  ///< trials of one are resampled together
};

struct Estimate {
    double value = 0;
    Interval interval;
};

/// P = Phi(constant + slopes[0] ln a + slopes[1] ln b).
struct TwoMeasureFit {
    Estimate constant;
    std::array<Estimate, 2> slopes;
    /// 1 / (slopes[0] + slopes[1]): the lognormal standard deviation along motions that scale both measures equally.
    Estimate beta;
    std::size_t better = 0;    ///< of the two measures the one that describes the trials better alone
    double deviance_gain = 0;  ///< by which both together fall below that one alone; about 1 by chance (chi squared
                               ///< with 1 degree of freedom, if every trial were independent)
    std::int64_t trials = 0, waves = 0;
};

/// Maximum likelihood by Newton's method; intervals from resampled waves, one Newton step each. Nothing where the
/// trials hold no such curve: all ended the same way or are separated, the measures are one another's multiple, or P
/// does not rise along both.
[[nodiscard]] std::optional<TwoMeasureFit> fit_two_measures(std::vector<TwoMeasureTrial> const& trials,
                                                            double confidence, BootstrapKey const& key);

}  // namespace overturn
