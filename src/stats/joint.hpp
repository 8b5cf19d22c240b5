/// Several bodies under one wave: how likely is it that any of them falls, and do they fall together?
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "stats/stripe.hpp"

namespace overturn {

/// End of one body under a wave at a level.
enum class JointEnd : std::uint8_t { stood, overturned, undecided };

/// All bodies under one wave at one level.
struct JointTrial {
    double amplitude = 0;
    std::vector<JointEnd> ends;  ///< one per body
    std::int64_t count = 1;      ///< so many waves ended so
};

/// Correlation of two bodies, over trials that decide both.
struct JointPair {
    std::size_t first = 0, second = 0;
    /// Correlation of the two outcomes (phi coefficient) at each level; nothing where either ended the same way
    /// throughout.
    std::vector<std::optional<double>> phi;
    /// The same pooled: covariances within levels, summed, over the root of the variances' sums.
    std::optional<double> pooled;
};

struct JointBodies {
    /// Per level: trials of all bodies together, `overturned` if any did; undecided where none did and one was not
    /// decided. Its interval requires independent waves, not independent bodies.
    std::vector<Stripe> any;
    std::vector<double> if_independent;  ///< 1 - product of (1 - P) of the bodies' own proportions; NaN: not known
    std::vector<JointPair> pairs;
};

/// \param group_size so many waves share what was drawn \pre every trial has the same number of ends
[[nodiscard]] JointBodies study_joint(std::span<JointTrial const> trials, double group_size = 1);

}  // namespace overturn
