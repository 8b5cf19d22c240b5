/// Trials side by side in the machine's vector lanes. Included by planar_rocking.cpp only.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "rocking/rocking_integrator.hpp"

namespace overturn::rocking {

/// As many trials at a time as the machine has lanes, each lane taking the next one when its own is over.
template <bool Vertical, Slip Friction> class Crew {
  public:
    using Trial = Integrator<SwingSeries::order, NonlinearRestoring, Vertical, Friction>;

    /// \param pauses filled if there are any
    Crew(std::span<RockingTrial const> trials, std::span<std::size_t const> queue, RockingAccuracy const& accuracy,
         std::span<RockingOutcome> outcomes, std::span<Pause> pauses)
        : trials_(trials), queue_(queue), accuracy_(accuracy), outcomes_(outcomes), pauses_(pauses) {}

    void work() {
        int const width = swing_width();
        for (int lane = 0; lane < width; ++lane) {
            aboard(lane);
        }
        while (busy_ > 0) {
            int const used = busy_ <= width / 2 ? close_ranks(width) : width;
            fill_idle(used);
            auto const calls = swing_on(lanes_, used, Vertical);
            for (int lane = 0; lane < used; ++lane) {
                if ((calls >> static_cast<unsigned>(lane) & 1U) != 0 && at_[lane].trial) {
                    at_[lane].trial->arrive(lanes_, lane);
                    go_on(lane);
                }
            }
        }
    }

  private:
    struct Place {
        std::optional<Trial> trial;
        std::size_t number = 0;
    };

    void aboard(int lane) {
        auto& place = at_[lane];
        place.trial.reset();
        if (next_ < queue_.size()) {
            place.number = queue_[next_++];
            auto const& trial = trials_[place.number];
            place.trial.emplace(trial.block, trial.shaking, accuracy_, nullptr);
            place.trial->begin({});
            ++busy_;
            go_on(lane);
        }
    }
    void go_on(int lane) {
        auto& place = at_[lane];
        if (place.trial->advance()) {
            place.trial->depart(lanes_, lane);
            return;
        }
        outcomes_[place.number] = place.trial->finish();
        if (!pauses_.empty()) {
            pauses_[place.number] = place.trial->pause();
        }
        --busy_;
        aboard(lane);
    }
    // The last trials move to the first lanes. Returns how many of those are in use: half of all.
    int close_ranks(int width) {
        int free = 0;
        for (int lane = width / 2; lane < width; ++lane) {
            if (at_[lane].trial) {
                while (at_[free].trial) {
                    ++free;
                }
                at_[free].trial.emplace(*at_[lane].trial);
                at_[free].number = at_[lane].number;
                at_[lane].trial.reset();
                lanes_.copy(lane, free);
            }
        }
        return width / 2;
    }
    // A lane without a trial shadows one that has one.
    void fill_idle(int used) {
        if (busy_ == used) {
            return;
        }
        int busy = 0;
        while (!at_[busy].trial) {
            ++busy;
        }
        for (int lane = 0; lane < used; ++lane) {
            if (!at_[lane].trial) {
                lanes_.copy(busy, lane);
            }
        }
    }

    std::span<RockingTrial const> trials_;
    std::span<std::size_t const> queue_;
    RockingAccuracy accuracy_;
    std::span<RockingOutcome> outcomes_;
    std::span<Pause> pauses_;
    std::size_t next_ = 0;
    int busy_ = 0;
    std::array<Place, most_lanes> at_;
    SwingLanes<most_lanes> lanes_;
};

}  // namespace overturn::rocking
