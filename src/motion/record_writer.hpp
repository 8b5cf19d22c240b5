/// Waves as files that other programs, and our own readers, read.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "motion/ground_motion.hpp"

namespace overturn {

/// One component in the layout of PEER's AT2: four header lines, accelerations in g, five to a line with eight digits.
/// \param identity event and station; files of one station share it
/// \param component H1, H2 or UP
[[nodiscard]] std::string at2_text(std::span<double const> acceleration_mps2, double time_step_s,
                                   std::string_view identity, std::string_view component);

/// Columns time_s, ax_mps2 and, where there are any, ay_mps2 (the other horizontal one) and az_mps2, with all digits.
[[nodiscard]] std::string csv_text(GroundMotion const& motion);

}  // namespace overturn
