/// Leaving on time: what signals and the time limit ask of a run.
#pragma once

#include <limits>

#include "core/elapsed.hpp"

namespace overturn {

inline constexpr int ends_resumable = 3;  ///< exit code of a rank that ends all where leaving together fails

/// Makes SIGUSR1, SIGUSR2, SIGTERM and SIGINT ask the run to stop instead of killing it. A second one, half a second
/// later or more, kills: launchers may deliver one request twice.
void stop_on_signals();

/// Restores the handlers from before stop_on_signals(), and raises again a signal that came meanwhile.
void restore_signals();

/// Decides when one rank stops. SIGUSR1 and the time limit let the block under way be finished; SIGTERM and SIGINT give
/// it half a second more, because mpirun and batch systems kill soon after; so does SIGUSR2, which mpirun hands on
/// without ending itself with a code of its own.
class StopPolicy {
  public:
    /// \param after_s from now on [s]
    explicit StopPolicy(double after_s = std::numeric_limits<double>::infinity());

    /// May another block be begun? Not if the longest one so far would not fit into the time that is left.
    [[nodiscard]] bool may_begin() const;
    /// May the block under way go on?
    [[nodiscard]] bool may_go_on() const;
    /// May the merge go on? For some time after a SIGUSR1: most are done by then, and it would begin anew.
    [[nodiscard]] bool may_merge() const;
    /// Is the time limit passed by more than leaving takes? Then this rank, or one that it waits for, hangs.
    [[nodiscard]] bool is_overdue() const { return overdue_in_s() <= 0; }
    /// Until then; infinite without a limit. [s]
    [[nodiscard]] double overdue_in_s() const;
    /// One more block took this long.
    void block_took(double seconds);
    /// The longest of them; 0: none yet.
    [[nodiscard]] double longest_block_s() const { return longest_s_; }

  private:
    [[nodiscard]] double elapsed_s() const;

    Clock::time_point begin_;
    double after_s_;
    double longest_s_ = 0;
};

}  // namespace overturn
