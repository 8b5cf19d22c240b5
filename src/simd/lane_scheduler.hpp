/// Many trajectories through the lanes of one kernel: a lane whose trajectory has ended takes the next one.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

#include "simd/lane_fields.hpp"

namespace overturn::simd {

/// Something that steps independent trajectories side by side. Of a lane, `step` does what all lanes do in common;
/// whatever is rare or differs from lane to lane is done to the trajectory itself, between `store_lane` and
/// `load_lane`.
template <class Kernel>
concept LaneKernel = requires(Kernel& kernel, std::optional<typename Kernel::Trajectory>& place,
                              typename Kernel::Trajectory& trajectory, typename Kernel::Fields& fields, int lane) {
    /// Lanes that `step` takes on this machine: at most most_lanes, and even unless one.
    { kernel.width() } -> std::same_as<int>;
    /// Emplaces the next trajectory. \return false, and nothing done, when there is none left
    { kernel.start_next(place) } -> std::same_as<bool>;
    /// Takes a trajectory on to where lanes can step it. \return false once it is over
    { kernel.advance(trajectory) } -> std::same_as<bool>;
    /// Finishes a trajectory that is over.
    kernel.finish(trajectory);
    /// A trajectory's state into its lane, and back.
    kernel.load_lane(trajectory, fields, lane);
    kernel.store_lane(trajectory, fields, lane);
    /// Steps the first `lane` lanes, all of them or half, until at least one has come to an end of what `step` does.
    /// Every lane holds a trajectory or a copy of one. \return one bit per such lane
    { kernel.step(fields, lane) } -> std::same_as<std::uint32_t>;
    /// One lane's fields over another's.
    fields.copy_lane(lane, lane);
}
&&std::move_constructible<typename Kernel::Trajectory>;

/// Lanes never mix, so where and beside which others a trajectory runs changes no bit of it.
template <LaneKernel Kernel> class LaneScheduler {
  public:
    /// \param kernel outlives this
    explicit LaneScheduler(Kernel& kernel) : kernel_(kernel), width_(kernel.width()) {}

    /// Until every trajectory is finished.
    void run() {
        for (int lane = 0; lane < width_; ++lane) {
            refill(lane);
        }
        while (running_ > 0) {
            int const used = running_ <= width_ / 2 ? compact() : width_;
            shadow(used);
            auto const ended = kernel_.step(fields_, used);
            for (int lane = 0; lane < used; ++lane) {
                auto& place = places_[lane];
                if ((ended >> static_cast<unsigned>(lane) & 1U) == 0 || !place) {
                    continue;
                }
                kernel_.store_lane(*place, fields_, lane);
                if (!go_on(lane)) {
                    refill(lane);
                }
            }
        }
    }

  private:
    // The next trajectory that needs a lane takes this one, which is free.
    void refill(int lane) {
        while (kernel_.start_next(places_[lane])) {
            ++running_;
            if (go_on(lane)) {
                return;
            }
        }
    }
    // \return false if the trajectory is over; the lane is then free
    bool go_on(int lane) {
        auto& place = places_[lane];
        if (kernel_.advance(*place)) {
            kernel_.load_lane(*place, fields_, lane);
            return true;
        }
        kernel_.finish(*place);
        place.reset();
        --running_;
        return false;
    }
    // The last trajectories move to the first lanes, so that half of the registers do. \return those lanes' number
    int compact() {
        int const half = width_ / 2;
        int free = 0;
        for (int lane = half; lane < width_; ++lane) {
            if (!places_[lane]) {
                continue;
            }
            while (places_[free]) {
                ++free;
            }
            places_[free].emplace(std::move(*places_[lane]));
            places_[lane].reset();
            fields_.copy_lane(lane, free);
        }
        return half;
    }
    // A lane without a trajectory shadows one that has one: registers have no idle lanes.
    void shadow(int used) {
        if (running_ == used) {
            return;
        }
        int running = 0;
        while (!places_[running]) {
            ++running;
        }
        for (int lane = 0; lane < used; ++lane) {
            if (!places_[lane]) {
                fields_.copy_lane(running, lane);
            }
        }
    }

    Kernel& kernel_;
    int width_;
    int running_ = 0;
    std::array<std::optional<typename Kernel::Trajectory>, most_lanes> places_;
    typename Kernel::Fields fields_;
};

}  // namespace overturn::simd
