/// How many trials the estimators of a problem will make, before they do: by their options, and by a look at how rare
/// failure is.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rare/crude.hpp"

namespace overturn::rare {

/// A small replicate of subset simulation at one factor.
struct Sounding {
    double factor = 0;
    bool reached = false;     ///< failure, in the time it had
    std::int64_t levels = 0;  ///< below the last, each a tenth as common; as many as may be where time was up
    double probability = 0;   ///< rough, within a decade or so; 0: not reached
    std::int64_t trials = 0;
    double seconds = 0;  ///< of them all, on the wall

    [[nodiscard]] double trial_s() const { return seconds / static_cast<double>(trials); }
};

/// Draws 16 waves, and goes on to 200 a level where that can be had in `most_s`.
[[nodiscard]] Sounding sound(Problem const& problem, double factor, std::uint64_t seed, double most_s);

/// Trials: a wave at one factor each.
struct Effort {
    double least = 0;   ///< each estimator that is tried can be trusted, and needs no more replicates
    double likely = 0;  ///< where a first estimator is tried, it is tried in vain: such a plan is rarely too low
    double most = 0;    ///< all estimators are tried, and add as many replicates as they may
};

/// Of one problem, as `estimate` goes about it. \param pulses has the problem a frame of pulses?
[[nodiscard]] Effort effort_of(std::span<Sounding const> soundings, bool pulses, std::optional<Method> method,
                               Request const& request);

}  // namespace overturn::rare
