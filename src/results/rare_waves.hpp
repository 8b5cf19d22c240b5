/// Waves that overturn a body although that is rare: what they have in common, and one as it came.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// The mean of similar failing waves, as it arrives most often: of the waves that do what this pulse does to
/// the body, the likeliest.
struct FailurePulse {
    double share = 0;     ///< share of the failing waves that look so [-]
    double factor = 0;    ///< on the waves where it was fitted
    GroundMotion motion;  ///< times the factor
};

/// A wave that overturned the body, and what the body did.
struct FailingWave {
    std::int64_t row = 0;  ///< of /rare/<body>/rows
    double factor = 0;
    GroundMotion motion;             ///< times the factor
    std::vector<double> tilt_rad{};  ///< over time
    std::vector<double> tilt_time_s{};
};

struct RareWaves {
    std::vector<FailurePulse> pulses;  ///< of the last pulses that a mixture drew from, the commonest first
    std::optional<FailingWave> failing;
};

/// \param body number in the campaign \pre the file holds rare events of it
[[nodiscard]] RareWaves rare_waves(store::ResultsReader const& file, CampaignSpec const& spec, std::size_t body);

}  // namespace overturn
