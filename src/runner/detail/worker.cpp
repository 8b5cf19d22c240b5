#include "runner/detail/worker.hpp"

#include <algorithm>

#include "campaign/block_rows.hpp"
#include "core/elapsed.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn {
namespace {

// From here on rank 0 serves the counters and leaves computing to the others.
constexpr int ranks_worth_serving = 64;
// Shares of what is left that each rank takes at once; ever smaller ones, so that all end together.
constexpr std::int64_t shares_each = 4;
constexpr double report_every_s = 1;
constexpr double soon_s = 0.1;                              // blocks computed together: a SIGTERM leaves half a second
constexpr double commit_every_s = 0.05;                     // what a kill may lose beside the blocks in hand
constexpr std::int64_t stop_mark = std::int64_t{1} << 40U;  // beside the blocks done, which never come near it

class Worker {
  public:
    Worker(Work const& what, std::vector<std::int64_t> const& left, StopPolicy& stop_policy,
           parallel::Communicator const& comm, Progress& progress)
        : what_(what),
          left_(left),
          stop_policy_(stop_policy),
          comm_(comm),
          progress_(progress),
          given_(comm),
          done_(comm) {}

    WorkDone work() {
        if (!comm_.is_root() || comm_.size() <= ranks_worth_serving) {
            compute();
        }
        comm_.wait_for_all([&] { show(); });
        return {comm_.is_root() ? done_.look() % stop_mark : 0, seconds_};
    }

    /// Why this rank had to end; empty if it had not to.
    [[nodiscard]] std::string const& failure() const { return failure_; }

  private:
    void compute() {
        while (!stopped_ && has_next()) {
            auto const begin = Clock::now();
            auto const blocks = next_blocks();
            auto rows = run_blocks(
                what_.spec, what_.plan, blocks, seconds_, [&] { return keep_running(); }, what_.known);
            stopped_ = !rows;
            for (std::size_t i = 0; i < blocks.size() && !stopped_; ++i) {
                computed_.push_back({blocks[i], (*rows)[i].pack()});
            }
            adapt_group(seconds_since(begin));
            if (seconds_since(committed_) > commit_every_s) {
                commit();
            }
            stop_policy_.block_took(seconds_since(begin));
            if (!stopped_ && seconds_since(reported_) > report_every_s) {
                report();
            }
        }
        commit();
        report();
    }

    // Takes the next share if this rank's is used up.
    bool has_next() {
        if (!stop_policy_.may_begin()) {
            stopped_ = true;
            return false;
        }
        std::int64_t const count = left_.size();
        if (next_ == end_) {
            auto const share = std::max<std::int64_t>(1, (count - end_) / (shares_each * comm_.size()));
            next_ = given_.take(share);
            end_ = next_ + share;
        }
        return next_ < count;
    }

    // Of the share.
    std::span<std::int64_t const> next_blocks() {
        auto const count = std::min(group_, std::min<std::int64_t>(end_, std::ssize(left_)) - next_);
        auto const blocks = std::span(left_).subspan(next_, count);
        next_ += count;
        return blocks;
    }

    // Groups grow from one block as far as they are worth it and done soon: nothing is kept of one that is broken off.
    void adapt_group(double took_s) {
        group_ = took_s > 2 * soon_s ? std::max<std::int64_t>(1, group_ / 2)
                 : took_s < soon_s   ? std::min(2 * group_, blocks_together(what_.plan))
                                     : group_;
    }

    // Adds what is done to all ranks' sum and hears whether one has stopped, which stops all.
    void report() {
        auto const before = done_.take(fresh_ + (stopped_ ? stop_mark : 0));
        stopped_ = stopped_ || before >= stop_mark;
        fresh_ = 0;
        reported_ = Clock::now();
    }

    [[nodiscard]] bool keep_running() const {
        if (comm_.is_root()) {
            comm_.serve();
        }
        return stop_policy_.may_go_on();
    }

    // Puts what is computed to disk; stops where that cannot be.
    void commit() {
        auto const begin = Clock::now();
        try {
            what_.shards.commit(computed_);
            fresh_ += std::ssize(computed_);
        } catch (SystemError const& error) {
            failure_ = error.what();
            stopped_ = true;
        }
        computed_.clear();
        committed_ = Clock::now();
        seconds_.store += seconds_since(begin);
        show();
    }

    void show() {
        if (comm_.is_root() && progress_.is_due()) {
            progress_.show(done_.look() % stop_mark + fresh_);
        }
    }

    Work const& what_;
    std::vector<std::int64_t> const& left_;
    StopPolicy& stop_policy_;
    parallel::Communicator const& comm_;
    Progress& progress_;
    parallel::SharedCounter given_, done_;
    PhaseSeconds seconds_;
    std::string failure_;
    std::int64_t next_ = 0, end_ = 0;           ///< this rank's share of `left_`
    std::vector<store::PackedBlock> computed_;  ///< and not on disk yet
    std::int64_t group_ = 1;                    ///< blocks to be computed together
    std::int64_t fresh_ = 0;                    ///< on disk and not reported yet
    Clock::time_point reported_ = Clock::now(), committed_ = reported_;
    bool stopped_ = false;
};

void print_failure(std::string const& failure, parallel::Communicator const& comm) {
    auto const failures = comm.gather(failure);
    (void)broadcast_from_root(comm, [&] {
        for (auto const& each : failures) {
            if (!each.empty()) {
                throw SystemError(each);
            }
        }
        return std::string();
    });
}

}  // namespace

void WorkDone::add(WorkDone const& more) {
    committed += more.committed;
    seconds.add(more.seconds);
}

WorkDone work(Work const& what, std::vector<std::int64_t> const& left, StopPolicy& stop_policy,
              parallel::Communicator const& comm, Progress& progress) {
    WorkDone done;
    std::string failure;
    {
        Worker worker(what, left, stop_policy, comm, progress);
        done = worker.work();
        failure = worker.failure();
    }
    print_failure(failure, comm);
    return done;
}

}  // namespace overturn
