/// A wave on another time grid.
#pragma once

#include <string>

#include "motion/ground_motion.hpp"

namespace overturn {

/// May the new step be longer than the old one? What shakes faster than its grid can follow is then taken off.
enum class Coarsening { refused, accepted };

struct Resampled {
    GroundMotion motion;
    std::string says;     ///< one line on what was done and what became of the peaks
    bool changed = true;  ///< is it another function of time?
};

/// A shorter step reads the wave's own straight lines at multiples of `time_step_s`. Where the new step divides the old
/// one this is the same function of time and no peak changes; otherwise corners between new samples are cut. A longer
/// one reads it behind a zero-phase low-pass (low_pass.hpp). The line says what became of PGA, PGV and PGD. The last
/// time is the last multiple within the wave. \throws InputError if the step is not positive, leaves fewer than two
/// samples, or is longer without being accepted
[[nodiscard]] Resampled resample(GroundMotion const& motion, double time_step_s, Coarsening coarsening);

}  // namespace overturn
