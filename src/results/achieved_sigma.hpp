/// By how much the waves of a campaign that draws targets differ, beside what was stated of their targets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"

namespace overturn {

/// Of one measure of the waves before any scaling.
struct AchievedMeasure {
    std::string name, label;  ///< "sa_1" and "sa(1.9 s)"
    /// Of the stated one [s]; of PGA, which is Sa towards a period of 0, the shortest of those that are matched.
    double period_s = 0;
    std::optional<double> stated;  ///< standard deviation of ln Sa of the targets, as a condition leaves it; none: not
                                   ///< matched there
    double achieved = 0;           ///< standard deviation of ln of the measure
    /// Its standard error of lognormal waves, achieved / sqrt(2 (independent - 1)): too large where what those of one
    /// target or event have of their own counts too.
    double error = 0;
};

/// What a campaign's waves made of the targets that were drawn for them.
struct AchievedSigma {
    std::int64_t waves = 0;        ///< made
    std::int64_t independent = 0;  ///< targets; where their parts are stated, events
    bool of_events = false;
    std::int64_t missed = 0;  ///< waves short of match_tolerance
    std::vector<AchievedMeasure> measures;

    /// "achieved sd of ln (stated of Sa), over 40 targets: pga 0.49 +- 0.06 (0.6 at 0.02 s, the shortest matched), ..."
    [[nodiscard]] std::string text() const;
};

/// Sums over waves, which come in their order.
class SigmaCount {
  public:
    explicit SigmaCount(CampaignSpec const& spec);
    void add(WaveRow const& row);
    /// Nothing where waves are not matched to drawn Sa, or fewer than two are independent.
    [[nodiscard]] std::optional<AchievedSigma> achieved(std::int64_t missed) const;

  private:
    struct Sum {
        AchievedMeasure of;
        double mean = 0, squares = 0;  // of deviations from the mean (Welford 1962)
    };
    void add(std::size_t place, double value);

    bool of_events_;
    std::vector<Sum> sums_;  // PGA first, then Sa at the campaign's periods; empty where nothing is stated
    std::int64_t waves_ = 0, independent_ = 0, last_ = 0;
};

}  // namespace overturn
