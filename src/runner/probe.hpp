/// Cost of a campaign, by a timed probe of a few of its waves.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "results/statistics.hpp"

namespace overturn {

struct ProbedCost {
    double generation_s = 0, measures_s = 0, trials_s = 0;  ///< of a wave with all its trials, on one rank
    double refused_per_wave = 0;                            ///< waves drawn in vain for one that counts
    WaveCounts waves;                                       ///< of the probe
    std::string none_accepted;                              ///< where no wave was: what they miss, and what helps
    PhaseSeconds models;                                    ///< of the trials that were answered
    double undecided_bodies = 0;                            ///< share of bodies of which some trials had no verdict

    [[nodiscard]] double wave_s() const { return generation_s + measures_s + trials_s; }
    /// Time for a wave that counts, with those that were drawn in vain [s].
    [[nodiscard]] double counted_wave_s() const { return wave_s() + refused_per_wave * (generation_s + measures_s); }
};

/// Draws up to 16 waves, or as many as a run answers together, spread over the campaign, for a second. Trials of two
/// are answered at some levels first, then those of 4 and of all at all levels, as long as that takes no second: dear
/// campaigns are estimated from the few.
/// \param spec its levels are thinned for a while
[[nodiscard]] ProbedCost probe(CampaignSpec& spec, Plan const& plan);

}  // namespace overturn
