/// Rows that all ranks make together.
#pragma once

#include "core/shared_rows.hpp"
#include "parallel/communicator.hpp"

namespace overturn::parallel {

/// ShareRows of all ranks: each makes every size-th row from its own number on, rank 0 puts them together and all have
/// the same. Collective. \pre `comm` outlives it
[[nodiscard]] ShareRows rows_of_ranks(Communicator const& comm);

}  // namespace overturn::parallel
