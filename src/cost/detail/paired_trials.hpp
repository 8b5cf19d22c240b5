/// Verdicts of the trials of some waves, kept so that two campaigns can be compared wave by wave.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "campaign/limit_state.hpp"
#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "cost/sensitivity.hpp"

namespace overturn::cost {

/// Ends by level, body and wave.
class PairedTrials {
  public:
    /// Runs the trials of prepared waves; `places` are their numbers in the sample.
    PairedTrials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves);

    /// Every wave drawn as often as `weights` says. Nothing where that holds no curve; of separated data the step.
    [[nodiscard]] std::optional<double> log_median(std::size_t body, std::size_t limit,
                                                   std::span<double const> weights) const;
    /// Are the levels too far apart for a median: at most one of them has both outcomes?
    [[nodiscard]] bool is_separated(std::size_t body, std::size_t limit, std::span<double const> weights) const;
    [[nodiscard]] Counts counts(std::size_t body, std::size_t limit, std::optional<double> amplitude) const;
    /// Differences from `before`, except medians.
    [[nodiscard]] Shift shift_from(PairedTrials const& before, std::size_t body, std::size_t limit) const;
    [[nodiscard]] std::optional<double> design_basis() const { return design_basis_; }

  private:
    [[nodiscard]] std::vector<FragilityPoint> points(std::size_t body, std::size_t limit,
                                                     std::span<double const> weights) const;

    /// One body at one level: an entry per wave of the sample; undecided where it was not tried.
    using Stripe = std::vector<LimitOutcomes>;
    std::map<double, std::vector<Stripe>> levels_;  ///< by amplitude, then body
    std::optional<double> design_basis_;
    std::vector<std::int64_t> groups_;  ///< of each wave of the sample: those of one share what was drawn
};

}  // namespace overturn::cost
