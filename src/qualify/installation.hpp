/// Checks that need a run in its place: a campaign gives its known bytes on these ranks and libraries, an interrupted
/// run gives them too, and the file system keeps what it is given.
#pragma once

#include <filesystem>

#include "parallel/communicator.hpp"
#include "qualify/check.hpp"

namespace overturn::qualify {

/// A campaign of three waves on all ranks (C-..). Collective; checks on rank 0, empty elsewhere.
/// \param folder an empty one that all ranks see
[[nodiscard]] Checks campaign_checks(std::filesystem::path const& folder, parallel::Communicator const& comm);

/// Durable writes and locks (F-..).
[[nodiscard]] Checks file_system_checks(std::filesystem::path const& folder);

}  // namespace overturn::qualify
