/// Analysis beyond one body and one measure: several bodies under one wave, and curves over two measures.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "results/statistics.hpp"
#include "stats/fragility.hpp"
#include "stats/joint.hpp"
#include "stats/two_measures.hpp"

namespace overturn {

/// All bodies under one wave, by one limit state.
struct BodiesTogether {
    std::string limit;
    Passing passing = Passing::overturned;
    JointBodies joint;
};
/// One per limit state; empty where there is one body, or waves are a grid. Of the trials that are held
/// (`most_trials_held`).
[[nodiscard]] std::vector<BodiesTogether> bodies_together(CampaignSpec const& spec, Statistics const& statistics);

/// Two measures of a campaign.
using MeasurePair = std::array<Measure, 2>;

/// "pga,v_wes": two different ones of those that the campaign's curves are over.
/// \throws InputError naming what there is
[[nodiscard]] MeasurePair parse_measures(std::string const& text, CampaignSpec const& spec);

struct TwoMeasures {
    std::string body, limit;
    std::array<std::string, 2> names;  ///< of the measures
    std::optional<TwoMeasureFit> fit;  ///< nothing: the trials hold no such curve
};
/// One per body and limit state.
[[nodiscard]] std::vector<TwoMeasures> over_two_measures(CampaignSpec const& spec, Statistics const& statistics,
                                                         MeasurePair const& measures, double confidence);

}  // namespace overturn
