/// Whether a wave may be used, and how right it is where these bodies rock.
#pragma once

#include <string>
#include <vector>

#include "campaign/body_spec.hpp"
#include "generators/wave_quality.hpp"
#include "generators/wave_source.hpp"
#include "spectra/band_rule.hpp"

namespace overturn {

struct WaveCheck {
    WaveQuality quality;
    std::vector<MatchFigures> bands;  ///< one per body, over [T0, T1]; all 0 where the source has no target
    std::vector<Clause> clauses;      ///< all clauses of the rule; empty without a rule
};

/// All clauses of a rule on a wave, including [T0, T1] of every body.
[[nodiscard]] WaveCheck check_wave(GeneratedWave const& wave, std::vector<BodySpec> const& bodies,
                                   RadiusUnit radius_unit);

/// \throws InputError if the source has a rule and a body's T1 lies beyond what its waves are compared at.
void validate_bands(WaveSource const& source, std::vector<BodySpec> const& bodies, RadiusUnit radius_unit);

}  // namespace overturn
