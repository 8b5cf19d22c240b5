/// Verbs that all ranks of a job do together.
#pragma once

#include <functional>

#include "parallel/communicator.hpp"

namespace overturn::cli {

/// Starts MPI and does it. \return the exit code: an error known to every rank is reported by one, an error on one rank
/// alone ends the whole job
[[nodiscard]] int on_all_ranks(std::function<int(parallel::Communicator const&)> const& action);

}  // namespace overturn::cli
