/// The trials without a verdict, for the reader of `status`.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/rows.hpp"

namespace overturn::output {

/// Collects them in order; keeps the first few and counts the rest.
class FailedTrials {
  public:
    explicit FailedTrials(CampaignSpec const& spec) : spec_(spec) {}

    /// Why the wave's trials may have no verdict. Before its trials.
    void know(WaveRow const& row);
    /// A row of the campaign; one with a verdict is passed over.
    void add(std::int64_t number, TrialRow const& row);
    /// Will the next failed row be listed whole, or only its reason be counted?
    [[nodiscard]] bool lists_more() const;
    /// A line on how many and why, then a line for each of the first ones; empty if there is none.
    [[nodiscard]] std::string text() const;

  private:
    CampaignSpec const& spec_;
    std::map<std::int64_t, std::int64_t> reasons_;
    std::vector<std::string> first_;
    std::map<std::int64_t, std::int64_t> clauses_;  ///< not met, by wave
    std::map<std::string, std::int64_t> not_met_;   ///< waves per clause
    std::int64_t count_ = 0;
};

}  // namespace overturn::output
