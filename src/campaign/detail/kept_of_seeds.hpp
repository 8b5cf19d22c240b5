/// Long periods of seed records that a match keeps.
#pragma once

#include <span>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "generators/wave_source.hpp"
#include "spectra/band_rule.hpp"

namespace overturn {

/// One seed's match over its goal. The goal for Sa is the target at matched periods, and the seed's own spectrum times
/// the last factor beyond them. The goal for PGV is the seed's own times the root mean square of those factors,
/// weighted by its pseudo-velocities squared. [-]
struct KeptOfSeed {
    double pgv = 1;
    double sa = 1;  ///< the geometric mean over the band of the body of which least is kept
    PeriodBand band;
};
/// \pre the wave was judged and its source has a seed of it; at least one band
[[nodiscard]] KeptOfSeed kept_of_seed(GroundMotion const& seed, GeneratedWave const& made,
                                      std::span<PeriodBand const> bands);

/// One line where PGV, or Sa over the band of a body, is 5 % lower than that in any of the first 8 waves; else empty.
[[nodiscard]] std::string warning_of_lost_periods(CampaignSpec const& spec);

}  // namespace overturn
