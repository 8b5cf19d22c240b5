/// Cost of each rare-event estimator for its scatter, on a campaign's own body and waves.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "cost/comparison.hpp"
#include "rare/estimate.hpp"

namespace overturn::cost {

/// One estimator at one effort.
struct RarePoint {
    rare::Method method = rare::Method::crude;
    std::string effort;      ///< "8 x 2000 a level"
    double seconds = 0;      ///< CPU, all of it
    std::int64_t waves = 0;  ///< made
    double cov = not_known;  ///< standard error over probability; not known: not trusted or not resolved
    bool foretold = false;   ///< crude: by the binomial law, from what one wave takes
    std::string reason;      ///< why there is no scatter; empty where there is
};

struct RareCost {
    std::string body;
    double amplitude = 0;               ///< the level in the middle
    std::optional<double> probability;  ///< the one that scatters least
    std::vector<RarePoint> points;
};

/// Study of the first body at the level in the middle: crude sampling by the binomial law, the pulse mixture where
/// waves are linear in their normals, and subset simulation, each at several efforts. Pure, except for the seconds.
/// \param done receives the share of the work that is done \pre the campaign has rare events
[[nodiscard]] RareCost study_rare(CampaignSpec const& spec, std::function<void(double)> const& done);

}  // namespace overturn::cost
