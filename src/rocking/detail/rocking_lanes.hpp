/// Trials side by side in the machine's vector lanes. Included by planar_rocking.cpp only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "rocking/detail/rocking_integrator.hpp"
#include "simd/lane_scheduler.hpp"

namespace overturn::rocking {

/// What a simd::LaneScheduler runs: rocking without slip in lanes, everything else in the trial's own integrator.
template <bool Vertical, Slip Friction> class RockingLanes {
  public:
    using Fields = RockingFields<most_lanes>;
    struct Trajectory {
        Trajectory(RockingTrial const& of, RockingAccuracy const& accuracy, std::size_t of_number)
            : trial(of.block, of.shaking, accuracy, nullptr), number(of_number) {}

        Integrator<LaneStep::order, NonlinearRestoring, Vertical, Friction> trial;
        std::size_t number;
    };

    RockingLanes(std::span<RockingTrial const> trials, std::span<std::size_t const> queue,
                 RockingAccuracy const& accuracy, std::span<RockingOutcome> outcomes, std::span<Checkpoint> checkpoints)
        : trials_(trials), queue_(queue), accuracy_(accuracy), outcomes_(outcomes), checkpoints_(checkpoints) {}

    [[nodiscard]] int width() const { return lane_width(); }
    bool start_next(std::optional<Trajectory>& place) {
        if (next_ == queue_.size()) {
            return false;
        }
        auto const number = queue_[next_++];
        place.emplace(trials_[number], accuracy_, number);
        place->trial.begin(trials_[number].start);
        return true;
    }
    bool advance(Trajectory& trajectory) { return trajectory.trial.advance(); }
    void load_lane(Trajectory const& trajectory, Fields& fields, int lane) { trajectory.trial.load_lane(fields, lane); }
    void store_lane(Trajectory& trajectory, Fields const& fields, int lane) {
        trajectory.trial.store_lane(fields, lane);
    }
    std::uint32_t step(Fields& fields, int used) { return step_lanes(fields, used, Vertical); }
    void finish(Trajectory& trajectory) {
        outcomes_[trajectory.number] = trajectory.trial.finish();
        if (!checkpoints_.empty()) {
            checkpoints_[trajectory.number] = trajectory.trial.checkpoint();
        }
    }

  private:
    std::span<RockingTrial const> trials_;
    std::span<std::size_t const> queue_;
    RockingAccuracy accuracy_;
    std::span<RockingOutcome> outcomes_;
    std::span<Checkpoint> checkpoints_;
    std::size_t next_ = 0;
};

/// The trials whose numbers stand in `queue`.
/// \param outcomes one per trial; so are checkpoints, which are filled if there are any
template <bool Vertical, Slip Friction>
void step_in_lanes(std::span<RockingTrial const> trials, std::span<std::size_t const> queue,
                   RockingAccuracy const& accuracy, std::span<RockingOutcome> outcomes,
                   std::span<Checkpoint> checkpoints) {
    RockingLanes<Vertical, Friction> lanes(trials, queue, accuracy, outcomes, checkpoints);
    simd::LaneScheduler(lanes).run();
}

}  // namespace overturn::rocking
