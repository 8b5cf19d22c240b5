/// Trials side by side in the machine's vector lanes, of a kernel that keeps all but its steps in a run of each trial.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace overturn::simd {

/// Kernel of a LaneScheduler for one kind of run. \tparam Run names its Trial (with block and shaking), Accuracy,
/// Outcome and Lanes; is made of block, shaking, accuracy and no start; has advance, lane, finish, and static width and
/// step
template <class Run> class RunBatch {
  public:
    using Fields = typename Run::Lanes;
    using Trial = typename Run::Trial;
    using Accuracy = typename Run::Accuracy;
    using Outcome = typename Run::Outcome;
    struct Trajectory {
        Trajectory(Trial const& trial, Accuracy const& accuracy, std::size_t of_number)
            : run(*trial.block, trial.shaking, accuracy, {}), number(of_number) {}

        Run run;
        std::size_t number;
    };

    /// \param queue the numbers of the trials to run, all of such lanes as may stand side by side \param before_each
    /// called before every trial, if there is such a thing; what it throws ends the batch
    RunBatch(std::span<Trial const> trials, std::span<std::size_t const> queue, Accuracy const& accuracy,
             std::span<Outcome> outcomes, std::function<void()> const& before_each)
        : trials_(trials), queue_(queue), accuracy_(accuracy), outcomes_(outcomes), before_each_(before_each) {}

    [[nodiscard]] int width() const { return Run::width(); }
    bool start_next(std::optional<Trajectory>& place) {
        if (next_ == queue_.size()) {
            return false;
        }
        if (before_each_) {
            before_each_();
        }
        auto const number = queue_[next_++];
        place.emplace(trials_[number], accuracy_, number);
        return true;
    }
    bool advance(Trajectory& trajectory) { return trajectory.run.advance(); }
    void load_lane(Trajectory const& trajectory, Fields& fields, int lane) {
        fields.take_lane(trajectory.run.lane(), 0, lane);
    }
    void store_lane(Trajectory& trajectory, Fields const& fields, int lane) {
        trajectory.run.lane().take_lane(fields, lane, 0);
    }
    std::uint32_t step(Fields& fields, int used) { return Run::step(fields, used); }
    void finish(Trajectory& trajectory) { outcomes_[trajectory.number] = trajectory.run.finish(); }

  private:
    std::span<Trial const> trials_;
    std::span<std::size_t const> queue_;
    Accuracy accuracy_;
    std::span<Outcome> outcomes_;
    std::function<void()> const& before_each_;
    std::size_t next_ = 0;
};

}  // namespace overturn::simd
