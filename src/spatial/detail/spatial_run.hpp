/// One trial in space: what is rare and what needs thought, between the steps that lanes take.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "spatial/detail/spatial_state.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn::spatial {

class SpatialRun {
  public:
    using Trial = SpatialTrial;
    using Accuracy = ContactAccuracy;
    using Outcome = SpatialOutcome;
    using Lanes = SpatialLanes<simd::most_lanes>;

    [[nodiscard]] static int width() { return step_width(); }
    [[nodiscard]] static std::uint32_t step(Lanes& lanes, int used) { return step_on(lanes, used); }

    /// \param block and what the shaking shows outlive this
    SpatialRun(SpatialBlock const& block, Excitation const& shaking, ContactAccuracy const& accuracy,
               std::optional<SpatialStart> const& start);

    /// On to where lanes can step. \return false once the trial is over
    [[nodiscard]] bool advance();
    [[nodiscard]] SpatialOutcome finish() const;

    /// The lane that holds the trial.
    [[nodiscard]] SpatialLanes<1>& lane() { return lane_; }
    [[nodiscard]] SpatialLanes<1> const& lane() const { return lane_; }
    [[nodiscard]] SpatialInstant instant() const;

  private:
    enum class Phase : std::uint8_t { resting, shaken, running_out };
    struct Acceleration {
        double x, y, z;
    };
    /// A point of the base as it lies in space.
    struct Placed {
        double x, y, z;  ///< from the base's centre
        double stiffness;
        double depth;  ///< negative: away
    };

    /// Stiffness of the points that touch, and its first and second moments over the base.
    struct BedMoments {
        double k, x, y, xx, xy, yy;
    };
    struct LeanStiffness {
        double xx, xy, yy;
    };
    /// How springs give way: slopes of the base along x and y, and the way of the centre of gravity.
    struct Yielding {
        double slope_x, slope_y, x, y, rise;
    };

    void fill_trial(ContactAccuracy const& accuracy);
    void fill_steps(ContactAccuracy const& accuracy);
    void fill_law();
    void fill_points();
    void place(SpatialStart const& start);
    void turn_by(std::array<double, 3> const& rotation_rad);
    void show_sample();
    void wake();
    void begin_run_out();
    void tell_peaks(SpatialOutcome& out) const;
    void tell_verdict(SpatialOutcome& out) const;
    [[nodiscard]] bool calm(std::size_t sample) const;
    [[nodiscard]] bool decided() const;
    [[nodiscard]] bool slipped() const;
    [[nodiscard]] bool sound() const;
    [[nodiscard]] double half_tilt_sine2() const;
    [[nodiscard]] double deepest_crush() const;
    [[nodiscard]] double mechanical_energy() const;
    /// Of motion and unbalance, over the mass: below it a body may be held at rest.
    [[nodiscard]] double quiet_energy() const;
    /// |a| / g_v at which the first point of the resting base parts, whatever the direction.
    [[nodiscard]] double parting_ratio() const;
    [[nodiscard]] Acceleration shaking_at(std::size_t sample) const;
    [[nodiscard]] std::array<double, 9> rotation() const;
    [[nodiscard]] std::array<double, 2> base_centre() const;
    [[nodiscard]] Placed placed(int point) const;
    [[nodiscard]] BedMoments bed_moments() const;
    [[nodiscard]] LeanStiffness lean_stiffness(BedMoments const& bed) const;
    [[nodiscard]] Yielding yielding(BedMoments const& bed, Acceleration const& by) const;
    [[nodiscard]] double get(State field) const { return lane_.body.at(field, 0); }
    void put(State field, double value) { lane_.body.at(field, 0) = value; }

    SpatialBlock const& block_;
    ContactBlock const& planar_;
    Excitation shaking_;
    std::size_t last_ = 0;  // sample
    double longest_step_s_ = 0;
    double run_out_s_ = 0;  // at most
    Phase phase_ = Phase::resting;
    Acceleration held_{};  // shaking under which the body came to rest
    SpatialLanes<1> lane_;
};

}  // namespace overturn::spatial
