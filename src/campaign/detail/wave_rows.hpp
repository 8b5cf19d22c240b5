/// A wave's row and its measures, from what was made of it.
#pragma once

#include "campaign/trial.hpp"
#include "campaign/wave_check.hpp"
#include "generators/drawn_target.hpp"
#include "generators/wave_source.hpp"

namespace overturn {

/// Fills the row's figures of the match to the target.
void describe_match(WaveRow& row, GeneratedWave const& wave);
/// Fills the row's figures of the target drawn for it.
void describe_drawn(WaveRow& row, DrawnTarget const& drawn);
/// Fills the row's duration and strength.
void describe_motion(WaveRow& row, GroundMotion const& motion, Intensity const& intensity);
/// Fills its quality, and for each body its match where that body rocks.
void describe_check(PreparedWave& wave, WaveCheck const& check);
/// Sa at the campaign's periods and over its band, 5 % damping.
void measure_sa(MeasureSpec const& measures, PreparedWave& wave);
/// V_WES and ouV_E over the band of this body.
void measure_energy(MeasureSpec const& spec, GroundMotion const& motion, RigidBody const& body, MeasureRow& row);

}  // namespace overturn
