/// Trials in space side by side in the machine's vector lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "simd/lane_scheduler.hpp"
#include "spatial/detail/spatial_run.hpp"

namespace overturn::spatial {

/// What a simd::LaneScheduler runs: steps in lanes, everything else in the trial's own run.
class SpatialBatch {
  public:
    using Fields = SpatialLanes<simd::most_lanes>;
    struct Trajectory {
        Trajectory(SpatialTrial const& trial, ContactAccuracy const& accuracy, std::size_t of_number)
            : run(*trial.block, trial.shaking, accuracy, {}), number(of_number) {}

        SpatialRun run;
        std::size_t number;
    };

    /// \param queue the numbers of the trials to run, all on bases of one kind
    SpatialBatch(std::span<SpatialTrial const> trials, std::span<std::size_t const> queue,
                 ContactAccuracy const& accuracy, std::span<SpatialOutcome> outcomes)
        : trials_(trials), queue_(queue), accuracy_(accuracy), outcomes_(outcomes) {}

    [[nodiscard]] int width() const { return step_width(); }
    bool start_next(std::optional<Trajectory>& place) {
        if (next_ == queue_.size()) {
            return false;
        }
        auto const number = queue_[next_++];
        place.emplace(trials_[number], accuracy_, number);
        return true;
    }
    bool advance(Trajectory& trajectory) { return trajectory.run.advance(); }
    void load_lane(Trajectory const& trajectory, Fields& fields, int lane) {
        fields.kind = trajectory.run.lane().kind;
        copy_lane(trajectory.run.lane(), 0, fields, lane);
    }
    void store_lane(Trajectory& trajectory, Fields const& fields, int lane) {
        copy_lane(fields, lane, trajectory.run.lane(), 0);
    }
    std::uint32_t step(Fields& fields, int used) { return step_on(fields, used); }
    void finish(Trajectory& trajectory) { outcomes_[trajectory.number] = trajectory.run.finish(); }

  private:
    template <int From, int To>
    static void copy_lane(SpatialLanes<From> const& from, int from_lane, SpatialLanes<To>& to, int to_lane) {
        for (int field = 0; field < static_cast<int>(State::count); ++field) {
            to.body.at(State{field}, to_lane) = from.body.at(State{field}, from_lane);
        }
        for (auto const wave : {Wave::x, Wave::y, Wave::z}) {
            to.body.at(wave, to_lane) = from.body.at(wave, from_lane);
        }
        for (int point = 0; point < from.kind.points; ++point) {
            for (int spot = 0; spot < static_cast<int>(Spot::count); ++spot) {
                to.at(Spot{spot}, point, to_lane) = from.at(Spot{spot}, point, from_lane);
            }
        }
    }

    std::span<SpatialTrial const> trials_;
    std::span<std::size_t const> queue_;
    ContactAccuracy accuracy_;
    std::span<SpatialOutcome> outcomes_;
    std::size_t next_ = 0;
};

}  // namespace overturn::spatial
