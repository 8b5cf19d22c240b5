#include "runner/detail/worker.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "campaign/block_rows.hpp"
#include "core/elapsed.hpp"
#include "core/print_note.hpp"
#include "runner/root_broadcast.hpp"

namespace overturn {
namespace {

// From here on rank 0 serves the counters and leaves computing to the others.
constexpr int ranks_worth_serving = 64;
// Shares of what is left that each rank takes at once; ever smaller ones, so that all end together.
constexpr std::int64_t shares_each = 4;
constexpr double report_every_s = 1;
constexpr double soon_s = 0.1;           // blocks computed together: a SIGTERM leaves half a second
constexpr double commit_every_s = 0.05;  // what a kill may lose beside the blocks under way
// A rank that has nothing left waits as long as its longest block took, within these bounds, before it takes a block
// over; before the next one it does not wait. tests/scale/ranks.py simulates it.
constexpr double least_patience_s = 0.3;
constexpr double patience_untried_s = 30;   // of a rank that computed no block
constexpr double taken_over_look_s = 0.25;  // how often a rank looks whether its blocks were taken over
// After so long a rank that does not come is taken for stopped or dead, and the run ends: blocks on disk stay.
constexpr double hung_after_s = 60, hung_after_blocks = 10, hung_look_s = 5;
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
        waits_since_ = looked_ = Clock::now();
        comm_.wait_for_all([&] {
            show();
            take_over();
            end_without_hung_ranks();
        });
        return {comm_.is_root() ? done_.look() % stop_mark : 0, seconds_};
    }

    /// Why this rank had to end; empty if it had not to.
    [[nodiscard]] std::string const& failure() const { return failure_; }

  private:
    void compute() {
        while (!stopped_ && has_next()) {
            auto const begin = Clock::now();
            auto const blocks = next_blocks();
            auto rows = run(blocks);
            if (!rows && are_there_) {
                fresh_ += std::ssize(blocks);
                give_up_taken_over();
                continue;
            }
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
        if (share_.empty()) {
            std::int64_t const count = left_.size();
            auto const size = std::max<std::int64_t>(1, (count - given_out_) / (shares_each * comm_.size()));
            auto const first = given_.take(size);
            given_out_ = first + size;
            auto const begin = left_.begin();
            share_.assign(begin + std::min(first, count), begin + std::min(given_out_, count));
        }
        return !share_.empty();
    }

    // Of the share.
    std::vector<std::int64_t> next_blocks() {
        auto const end = share_.begin() + std::min(group_, std::ssize(share_));
        std::vector<std::int64_t> blocks(share_.begin(), end);
        share_.erase(share_.begin(), end);
        return blocks;
    }

    // Where others took blocks of this rank over, they took more than one.
    void give_up_taken_over() {
        if (share_.empty()) {
            return;
        }
        std::vector<std::int64_t> left;
        std::vector<std::string> ignored;
        std::ranges::set_difference(share_, what_.shards.committed({share_.front(), share_.back() + 1}, ignored),
                                    std::back_inserter(left));
        fresh_ += std::ssize(share_) - std::ssize(left);
        share_ = std::move(left);
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

    // None: it is time to go, or another rank computed them meanwhile (are_there_).
    std::optional<std::vector<BlockRows>> run(std::span<std::int64_t const> blocks) {
        are_there_ = false;
        auto const whole = std::ranges::find_if(blocks, [&](std::int64_t block) { return is_kept(block); });
        return whole == blocks.end() ? computed(blocks) : with_kept(blocks);
    }

    [[nodiscard]] bool is_kept(std::int64_t block) const {
        return what_.known != nullptr && what_.known->has_all(block);
    }

    std::optional<std::vector<BlockRows>> computed(std::span<std::int64_t const> blocks) {
        return run_blocks(
            what_.spec, what_.plan, blocks, seconds_, [&] { return keep_running() && !are_taken_over(blocks); },
            what_.known);
    }

    // Where an earlier campaign left all rows of some of them.
    std::optional<std::vector<BlockRows>> with_kept(std::span<std::int64_t const> blocks) {
        std::vector<BlockRows> all;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (!is_kept(blocks[i])) {
                auto rows = computed(blocks.subspan(i, 1));
                if (!rows) {
                    return std::nullopt;
                }
                all.push_back(std::move(rows->front()));
            } else if (keep_running()) {
                all.push_back(what_.known->block(blocks[i]));
            } else {
                return std::nullopt;
            }
        }
        return all;
    }

    // Has another rank computed the blocks under way? Only where none is left to be given out.
    bool are_taken_over(std::span<std::int64_t const> blocks) {
        if (comm_.size() == 1 || seconds_since(looked_) < taken_over_look_s) {
            return are_there_;
        }
        looked_ = Clock::now();
        are_there_ = given_.look() >= std::ssize(left_)
                     && std::ranges::all_of(blocks, [&](std::int64_t block) { return is_sound(block); });
        return are_there_;
    }

    [[nodiscard]] bool is_sound(std::int64_t block) const {
        std::vector<std::string> ignored;
        return !what_.shards.committed({block, block + 1}, ignored).empty();
    }

    // By the names of the files.
    [[nodiscard]] std::vector<std::int64_t> not_on_disk() const {
        auto const there = what_.shards.listed({left_.front(), left_.back() + 1});
        std::vector<std::int64_t> missing;
        std::ranges::set_difference(left_, there, std::back_inserter(missing));
        return missing;
    }

    // While this rank waits: computes a block that a stopped or slow rank holds. Whoever commits it first, its bytes
    // are the same; the rank that holds it counts it, and breaks it off when it finds it there.
    void take_over() {
        double const longest_s = stop_policy_.longest_block_s();
        double const patience_s = longest_s > 0 ? std::max(least_patience_s, longest_s) : patience_untried_s;
        if (stopped_ || left_.empty() || seconds_since(looked_) < patience_s || !stop_policy_.may_begin()) {
            return;
        }
        looked_ = Clock::now();
        ++looks_;
        auto const done = done_.look();
        auto const missing = done < stop_mark ? std::ssize(left_) - done : 0;
        // Of many idle ranks about twice as many as blocks are missing look into the folder, other ones each time.
        constexpr std::int64_t step = 40'503;
        std::int64_t const turn = (comm_.rank() + looks_ * step) % comm_.size();
        if (missing <= 0 || turn >= 2 * missing) {
            return;
        }
        auto const held = not_on_disk();
        if (held.empty()) {
            return;
        }
        // Few ranks go through parts of their own, so that none computes what another one is computing.
        auto const count = std::ssize(held);
        auto const block = held[comm_.size() > 2 * missing ? turn % count : comm_.rank() * count / comm_.size()];
        if (auto rows = run(std::span(&block, 1))) {
            computed_.push_back({block, rows->front().pack()});
            commit();
            fresh_ = 0;  // whoever holds it counts it
        }
        looked_ = {};
    }

    // Ends all ranks where one does not come though nothing is left to be computed, or time is up.
    void end_without_hung_ranks() {
        double const waited_s = seconds_since(waits_since_);
        double const most_s = std::max(hung_after_s, hung_after_blocks * stop_policy_.longest_block_s());
        bool const overdue = stop_policy_.is_overdue();
        if (!comm_.is_root() || comm_.size() == 1 || left_.empty() || (waited_s < most_s && !overdue)
            || seconds_since(looked_for_hung_) < hung_look_s) {
            return;
        }
        looked_for_hung_ = Clock::now();
        auto const missing = not_on_disk().size();
        if (missing > 0 && !overdue && !stopped_) {
            return;
        }
        print_note(
            "overturn: a rank has not answered for {:.0f} s (stopped, or its node is down): all ranks end, {} of {} "
            "blocks of this run are on disk. Go on with the same command and --resume\n",
            waited_s, left_.size() - missing, left_.size());
        comm_.abort(ends_resumable);
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
    std::vector<std::int64_t> share_;           ///< this rank's of `left_`, and not begun
    std::int64_t given_out_ = 0;                ///< blocks of `left_`, when this rank last asked
    std::vector<store::PackedBlock> computed_;  ///< and not on disk yet
    std::int64_t group_ = 1;                    ///< blocks to be computed together
    std::int64_t fresh_ = 0;                    ///< on disk and not reported yet
    Clock::time_point reported_ = Clock::now(), committed_ = reported_;
    Clock::time_point looked_ = reported_;  ///< for blocks that another rank computed, or holds
    Clock::time_point waits_since_ = reported_, looked_for_hung_ = reported_;
    std::int64_t looks_ = 0;
    bool are_there_ = false;  ///< the blocks under way, of another rank
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
