/// What the trials of a campaign say beyond one body and one measure: several bodies under one wave, and curves over
/// two measures.
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
/// One per limit state; empty where there is one body, or waves are a grid. Of the trials that are held (the first
/// million).
[[nodiscard]] std::vector<BodiesTogether> bodies_together(CampaignSpec const& spec, Statistics const& statistics);

/// \param confidence of the exact intervals
[[nodiscard]] std::string together_table(CampaignSpec const& spec, std::vector<BodiesTogether> const& together,
                                         double confidence);

/// Two measures of a campaign.
using MeasurePair = std::array<FragilityMeasure, 2>;

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

[[nodiscard]] std::string two_measures_text(std::vector<TwoMeasures> const& fits, double confidence);

}  // namespace overturn
