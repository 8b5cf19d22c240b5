#include "campaign/worker.hpp"

#include <chrono>

#include "campaign/agreement.hpp"

namespace overturn {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// From here on rank 0 serves the counter and leaves computing to the others.
constexpr int ranks_worth_serving = 64;

class Worker {
  public:
    Worker(CampaignSpec const& spec, Plan const& plan, std::vector<std::int64_t> const& left,
           store::ShardFolder const& shards, Leave& leave, parallel::Communicator const& comm, Progress& progress)
        : spec_(spec),
          plan_(plan),
          left_(left),
          shards_(shards),
          leave_(leave),
          comm_(comm),
          progress_(progress),
          given_(comm),
          done_(comm) {}

    WorkDone work() {
        if (!comm_.is_root() || comm_.size() <= ranks_worth_serving) {
            compute();
        }
        comm_.wait_for_all([&] { show(); });
        return {comm_.is_root() ? done_.look() : 0, seconds_};
    }

    /// Why this rank had to end; empty if it had not to.
    [[nodiscard]] std::string const& failure() const { return failure_; }

  private:
    void compute() {
        auto const count = static_cast<std::int64_t>(left_.size());
        for (auto turn = next(count); turn < count; turn = next(count)) {
            auto const begin = Clock::now();
            auto const block = left_[static_cast<std::size_t>(turn)];
            auto const rows = run_block(spec_, plan_, block, seconds_, [&] { return goes_on(); });
            if (!rows || !commit(block, rows->pack())) {
                (void)given_.take(count);  // nobody gets another block
                return;
            }
            leave_.block_took(seconds_since(begin));
        }
    }

    std::int64_t next(std::int64_t count) { return leave_.may_begin() ? given_.take() : given_.take(count) + count; }

    [[nodiscard]] bool goes_on() const {
        if (comm_.is_root()) {
            comm_.serve();
        }
        return leave_.may_go_on();
    }

    bool commit(std::int64_t block, std::span<std::byte const> rows) {
        auto const begin = Clock::now();
        try {
            shards_.commit(block, rows);
        } catch (SystemError const& error) {
            failure_ = error.what();
            return false;
        }
        seconds_.store += seconds_since(begin);
        (void)done_.take();
        show();
        return true;
    }

    void show() {
        if (comm_.is_root() && progress_.is_due()) {
            progress_.show(done_.look());
        }
    }

    CampaignSpec const& spec_;
    Plan const& plan_;
    std::vector<std::int64_t> const& left_;
    store::ShardFolder const& shards_;
    Leave& leave_;
    parallel::Communicator const& comm_;
    Progress& progress_;
    parallel::SharedCounter given_, done_;
    PhaseSeconds seconds_;
    std::string failure_;
};

void tell(std::string const& failure, parallel::Communicator const& comm) {
    auto const failures = comm.gather(failure);
    (void)from_root(comm, [&] {
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

WorkDone work(CampaignSpec const& spec, Plan const& plan, std::vector<std::int64_t> const& left,
              store::ShardFolder const& shards, Leave& leave, parallel::Communicator const& comm, Progress& progress) {
    WorkDone done;
    std::string failure;
    {
        Worker worker(spec, plan, left, shards, leave, comm, progress);
        done = worker.work();
        failure = worker.failure();
    }
    tell(failure, comm);
    return done;
}

}  // namespace overturn
