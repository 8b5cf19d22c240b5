/// What engineers would say by hand, beside what was simulated: a conservative deterministic (CDFM) cross-check by the
/// approximate methods of ASCE/SEI 43-05, Appendix A (body/reserve_energy.hpp), on the campaign's own waves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "body/reserve_energy.hpp"
#include "campaign/campaign_spec.hpp"

namespace overturn {

struct HandCheck {
    std::string body;
    std::int64_t waves = 0;  ///< the campaign's first, whose spectra's 84 % fractile is the demand
    std::string left_out;    ///< components of these waves that the method as it stands here knows nothing of
    /// The level at which the spectrum asks as much as the body can give at `rocking` and more at any other rotation:
    /// it overturns beyond [SI of the levels' measure]
    double overturning_level = 0;
    RockingCapacity rocking;
    /// Where the body has a friction and the campaign a design basis: how far it slides there [m]; 0: not at all
    std::optional<double> sliding_m;
    double sliding_frequency_hz = 0;
};

/// Of the bodies as stated, undrawn, under the horizontal component: others that the waves have are left out, which is
/// unsafe, and said. Empty where waves are a grid or none can be
/// scaled.
[[nodiscard]] std::vector<HandCheck> hand_checks(CampaignSpec const& spec);

[[nodiscard]] std::string hand_check_text(CampaignSpec const& spec, std::vector<HandCheck> const& checks);

}  // namespace overturn
