/// FILE.runtime.json: what a run took, per rank; nothing of it is in the results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "parallel/communicator.hpp"

namespace overturn {

/// One rank's seconds, to be gathered.
[[nodiscard]] std::string seconds_text(parallel::Communicator const& comm, PhaseSeconds const& seconds);

/// The rungs of all ranks, from their seconds_text.
[[nodiscard]] PhaseSeconds sum_of_rungs(std::vector<std::string> const& ranks);

/// Beside `output`: FILE.runtime.json, or FILE.part-2-of-8.runtime.json. A failure is said on stderr and no more: the
/// results do not depend on it.
void write_runtime(std::filesystem::path const& output, Part part, std::vector<std::string> const& ranks, double wall_s,
                   std::int64_t trials);

}  // namespace overturn
