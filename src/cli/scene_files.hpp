/// The files that rock and spectrum take: one record, one body.
#pragma once

#include <optional>
#include <string>

#include "campaign/body_spec.hpp"
#include "motion/ground_motion.hpp"

namespace overturn::cli {

/// \param unit empty if the file itself must say it; \param time_step e.g. "0.01 s", for files without a time column
[[nodiscard]] GroundMotion load_motion(std::string const& path, std::string const& unit, std::string const& time_step);

[[nodiscard]] BodySpec load_body(std::string const& path);

}  // namespace overturn::cli
