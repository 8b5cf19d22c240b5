/// By how much the waves of a campaign that draws targets differ, beside what was stated of their targets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"

namespace overturn {

/// Scatter of one measure of the waves before any scaling.
struct AchievedMeasure {
    std::string name, label;  ///< "sa_1" and "sa(1.9 s)"
    /// Period of the stated one [s]; for PGA, which is Sa towards a period of 0, the shortest of those that are
    /// matched.
    double period_s = 0;
    std::optional<double> stated;  ///< standard deviation of ln Sa of the targets, as a condition leaves it; none: not
                                   ///< matched there
    /// Standard deviation of ln of the measure, by its parts between and within targets or events: what these have in
    /// common is not counted short where they are few.
    double achieved = 0;
    /// Standard error of it, for lognormal waves, achieved / sqrt(2 (independent - 1)): too large where what those of
    /// one target or event have of their own counts too.
    double error = 0;
};

/// Scatter that a campaign's waves achieved, beside that of the targets drawn for them.
struct AchievedSigma {
    std::int64_t waves = 0;        ///< made
    std::int64_t independent = 0;  ///< targets; where their parts are stated, events
    bool of_events = false;
    std::int64_t missed = 0;  ///< waves short of match_tolerance
    std::vector<AchievedMeasure> measures;
};

/// Sums over waves, which come in their order.
class SigmaCount {
  public:
    explicit SigmaCount(CampaignSpec const& spec);
    void add(WaveRow const& row);
    /// Is there anything to count: are waves matched to drawn Sa?
    [[nodiscard]] bool counts() const { return !sums_.empty(); }
    /// Nothing where waves are not matched to drawn Sa, or fewer than two are independent.
    [[nodiscard]] std::optional<AchievedSigma> achieved(std::int64_t missed) const;

  private:
    struct Moments {  // Welford (1962)
        double mean = 0, squares = 0;
        void add(double value, std::int64_t count);
    };
    struct Sum {
        AchievedMeasure of;
        Moments group, means;  // of the target or event that is being added, and of those before
        double within = 0;     // squares about the means of those before
    };
    void close_group();
    [[nodiscard]] AchievedSigma of_whole_groups(std::int64_t missed) const;

    bool of_events_;
    std::vector<Sum> sums_;  // PGA first, then Sa at the campaign's periods; empty where nothing is stated
    std::int64_t waves_ = 0, independent_ = 0, in_group_ = 0, last_ = 0;
};

}  // namespace overturn
