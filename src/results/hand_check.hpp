/// Hand calculation beside the simulation: a cross-check by energy balances (body/reserve_energy.hpp) under the 84 %
/// spectrum of the campaign's own waves.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "body/reserve_energy.hpp"
#include "campaign/campaign_spec.hpp"
#include "results/analysis.hpp"
#include "results/statistics.hpp"

namespace overturn {

struct HandCheck {
    std::string body;
    std::int64_t waves = 0;  ///< the campaign's first, of whose spectra a fractile is the demand
    double fractile = 0;     ///< 0.84, or 1 (the highest) of fewer than five waves
    std::string left_out;    ///< components of these waves that the overturning level knows nothing of
    /// The level at which the spectrum asks as much as the body can give at `rocking` and more at any other rotation:
    /// it overturns beyond [SI of the levels' measure]
    double overturning_level = 0;
    RockingCapacity rocking;
    /// Sliding distance at the design basis [m], where the body has a friction and the campaign a design basis; 0: none
    std::optional<double> sliding_m;
    double sliding_frequency_hz = 0;
    /// Of the curve over the levels, by `compare`. Without a curve the lowest level at which half of the trials or more
    /// overturned; none where fewer did at every level.
    std::optional<double> simulated_median;

    /// Does the body overturn at lower levels by simulation? The calculation by hand is then not to be quoted.
    [[nodiscard]] bool is_unsafe() const { return simulated_median && overturning_level > *simulated_median; }
};

/// Checks of the bodies as stated, undrawn. Overturning neglects a vertical component, which is unsafe; the output says
/// so. Empty where waves are a grid or none can be scaled.
[[nodiscard]] std::vector<HandCheck> hand_checks(CampaignSpec const& spec);

/// Gives every check the simulated median of its body. \param analysis of these statistics
void compare(std::span<HandCheck> checks, Statistics const& statistics, std::span<BodyAnalysis const> analysis);

}  // namespace overturn
