/// Verbs that all ranks of a job do together.
#pragma once

#include <functional>

#include "parallel/communicator.hpp"

namespace overturn::cli {

/// Starts MPI and does it. \return the exit code: what every rank knows of is told by one, what one alone knows of ends
/// the whole job
[[nodiscard]] int on_all_ranks(std::function<int(parallel::Communicator const&)> const& action);

}  // namespace overturn::cli
