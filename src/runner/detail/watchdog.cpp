#include "runner/detail/watchdog.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <string>

#include "core/next_step.hpp"
#include "core/print_note.hpp"
#include "runner/progress.hpp"

namespace overturn {
namespace {

constexpr int last_in_turn = 3;  // this rank and all after it end together

void end_overdue(std::stop_token const& told_to_leave, std::chrono::duration<double> after, std::string const& advice) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wait;
    wait.wait_for(lock, told_to_leave, std::chrono::ceil<std::chrono::milliseconds>(after), [] { return false; });
    if (!told_to_leave.stop_requested()) {
        print_note(
            "overturn: time is up, and a rank has not answered, or a disk (stopped, or a node is down): all ranks end. "
            "Blocks on disk are kept: {}\n",
            advice);
        tell_end(ends_resumable);
        std::_Exit(ends_resumable);
    }
}

}  // namespace

Watchdog::Watchdog(StopPolicy const& stop_policy, parallel::Communicator const& comm) {
    if (auto const overdue_s = stop_policy.overdue_in_s(); std::isfinite(overdue_s)) {
        double const turn_s = 1 + std::min(comm.rank(), last_in_turn);
        thread_ = std::jthread(end_overdue, std::chrono::duration<double>(overdue_s + turn_s), next_step());
    }
}

}  // namespace overturn
