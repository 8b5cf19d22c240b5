/// Effect of the integration's step on every quantity that a limit state may use, beside the effect of a last bit.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "campaign/trial.hpp"
#include "cost/comparison.hpp"

namespace overturn::cost {

/// Differences over the larger value, of trials that end the same way and have the quantity.
struct QuantityError {
    std::string name, units;
    Spread step;      ///< from the campaign's steps to half of them
    Spread rounding;  ///< from the motions to ones whose samples are all a last bit smaller
};

struct StepError {
    std::int64_t trials = 0;
    std::int64_t step_flips = 0, rounding_flips = 0;  ///< other verdicts
    std::vector<QuantityError> quantities;            ///< those that some trial has

    [[nodiscard]] double step_flips_per_thousand() const { return per_thousand(step_flips); }
    [[nodiscard]] double rounding_flips_per_thousand() const { return per_thousand(rounding_flips); }

  private:
    [[nodiscard]] double per_thousand(std::int64_t flips) const {
        constexpr double thousand = 1000;
        return trials > 0 ? thousand * static_cast<double>(flips) / static_cast<double>(trials) : 0;
    }
};

/// The same trials at the campaign's steps, at half of them (on points and of rigid bodies), and under motions that
/// differ in their last bits: what chaos makes of nothing. Pure. \param waves of the campaign
[[nodiscard]] StepError study_step_error(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan,
                                         std::span<PreparedWave const> waves);

}  // namespace overturn::cost
