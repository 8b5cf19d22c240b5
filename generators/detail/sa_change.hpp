/// Change of a record's response spectrum by a new time grid or a corrected baseline.
#pragma once

#include <string>

#include "motion/ground_motion.hpp"

namespace overturn {

/// ", Sa from 0.3 to 10 s by -0.4 % at most"; of several components "; Sa from 0.3 to 10 s by -0.4 % at most,
/// transverse by +1 %, vertical by -3 %": over the periods that bodies rock at, 5 % damping.
[[nodiscard]] std::string sa_change_text(GroundMotion const& from, GroundMotion const& to);

}  // namespace overturn
