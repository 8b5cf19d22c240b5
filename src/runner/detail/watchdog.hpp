/// The end of a rank that waits for ever: for another one that has stopped, or for a file server.
#pragma once

#include <stop_token>
#include <thread>

#include "parallel/communicator.hpp"
#include "runner/stop_policy.hpp"

namespace overturn {

/// While one lives, a process that is still there when its run is overdue says so and ends with the code of a run that
/// can be resumed; the launcher then ends all others. Lower ranks are first, so that one speaks. It needs nothing from
/// MPI, rank 0, or whatever the process waits for.
class Watchdog {
  public:
    Watchdog(StopPolicy const& stop_policy, parallel::Communicator const& comm);

  private:
    std::jthread thread_;
};

}  // namespace overturn
