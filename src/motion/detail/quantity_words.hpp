/// The words that name what numbers are: in the names of columns and in prose.
#pragma once

#include <string_view>

#include "motion/column_role.hpp"

namespace overturn {

/// Quantity by a column's name without its unit: "Velocity", "velNS", "vx", "No.", "HHE" (a seismometer's velocity).
[[nodiscard]] Quantity quantity_in_name(std::string_view name);

/// Is the name of letters alone, "vx", "d", "HHE", so that a unit beside it says more than it does?
[[nodiscard]] bool unit_decides(std::string_view name);

/// Quantity of all numbers below a line of prose: "Velocity time history", "type: VEL", "units: counts". Unknown where
/// it speaks of something else by such words ("velocity sensor", "compatible with a spectrum") or says more than a
/// label.
[[nodiscard]] Quantity quantity_in_prose(std::string_view lower);

/// "velocities", "displacements", ... for messages; empty for what may be accelerations.
[[nodiscard]] std::string_view plural_of(Quantity quantity);

}  // namespace overturn
