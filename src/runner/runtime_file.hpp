/// FILE.runtime.json: what an output took, segment by segment and rank by rank, and on what; nothing of it is in the
/// results.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/trial.hpp"
#include "parallel/communicator.hpp"

namespace overturn {

/// One rank's seconds, libm and vector lanes, to be gathered.
[[nodiscard]] std::string seconds_text(parallel::Communicator const& comm, PhaseSeconds const& seconds);

/// The models of all ranks, from their seconds_text.
[[nodiscard]] PhaseSeconds sum_of_models(std::vector<std::string> const& ranks);

/// Wall time of a run on rank 0, from the start of its program to its end, as `plan` forecasts it [s].
struct RunSeconds {
    double start = 0;  ///< before the first block: reading, calibrations, warnings
    double work = 0;   ///< of all blocks
    double rare = 0;   ///< of rare events
    double merge = 0;  ///< rows, curves and tables
    double wall = 0;   ///< all of it
};

/// Record of one run, or one part: program, compiler, libraries, and all its ranks.
[[nodiscard]] std::string segment_text(Part part, std::vector<std::string> const& ranks, RunSeconds const& seconds,
                                       std::int64_t trials);

/// Beside `output`, of all its segments. A failure is only reported on stderr: the results do not depend on it.
/// \param merge_s of merging them in a program of its own, from its start [s]
void write_runtime(std::filesystem::path const& output, std::span<std::string const> segments, double merge_s = 0);

}  // namespace overturn
