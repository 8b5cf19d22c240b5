/// Trials of planar rocking side by side in the machine's vector lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "rocking/detail/lane_run.hpp"
#include "simd/lane_scheduler.hpp"

namespace overturn::rocking {

/// Kernel of a simd::LaneScheduler: rocking without slip in lanes, everything else in the trial's own run.
class RockingLanes {
  public:
    using Fields = RockingFields<most_lanes>;
    struct Trajectory {
        RockingRun run;
        std::size_t number;
    };

    /// \param queue the numbers of the trials to run: all with a vertical component, or all without
    /// \param outcomes one per trial; so are checkpoints, which are filled if there are any
    RockingLanes(std::span<RockingTrial const> trials, std::span<std::size_t const> queue,
                 RockingAccuracy const& accuracy, Slip slip, std::span<RockingOutcome> outcomes,
                 std::span<Checkpoint> checkpoints)
        : trials_(trials),
          queue_(queue),
          accuracy_(accuracy),
          slip_(slip),
          outcomes_(outcomes),
          checkpoints_(checkpoints),
          vertical_(!queue.empty() && !trials[queue.front()].shaking.vertical_mps2.empty()) {}

    [[nodiscard]] int width() const { return lane_width(); }
    bool start_next(std::optional<Trajectory>& place) {
        if (next_ == queue_.size()) {
            return false;
        }
        auto const number = queue_[next_++];
        auto const& trial = trials_[number];
        place.emplace(Trajectory{{trial.block, trial.shaking, accuracy_, slip_, nullptr}, number});
        begin(place->run, trial.start);
        return true;
    }
    bool advance(Trajectory& trajectory) { return rocking::advance(trajectory.run); }
    void load_lane(Trajectory const& trajectory, Fields& fields, int lane) {
        rocking::load_lane(trajectory.run, fields, lane);
    }
    void store_lane(Trajectory& trajectory, Fields const& fields, int lane) {
        rocking::store_lane(trajectory.run, fields, lane);
    }
    std::uint32_t step(Fields& fields, int used) const { return step_lanes(fields, used, vertical_); }
    void finish(Trajectory& trajectory) {
        outcomes_[trajectory.number] = rocking::finish(trajectory.run);
        if (!checkpoints_.empty()) {
            checkpoints_[trajectory.number] = trajectory.run.checkpoint;
        }
    }

  private:
    std::span<RockingTrial const> trials_;
    std::span<std::size_t const> queue_;
    RockingAccuracy accuracy_;
    Slip slip_;
    std::span<RockingOutcome> outcomes_;
    std::span<Checkpoint> checkpoints_;
    bool vertical_;
    std::size_t next_ = 0;
};

}  // namespace overturn::rocking
