/// One trial in space, all but the steps that lanes take: how it starts, rests and wakes, when it is over, its outcome.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "contact/point_run.hpp"
#include "spatial/detail/spatial_state.hpp"
#include "spatial/spatial_motion.hpp"

namespace overturn::spatial {

class SpatialRun : public contact::PointRun<SpatialRun, State, Spot, SpatialLanes<1>> {
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

    [[nodiscard]] SpatialOutcome finish() const;

    [[nodiscard]] SpatialInstant instant() const;

  private:
    using Base = contact::PointRun<SpatialRun, State, Spot, SpatialLanes<1>>;
    friend Base;
    static constexpr std::array shaken_by{State::ax,        State::ax_change, State::ay,
                                          State::ay_change, State::az,        State::az_change};

    struct Acceleration {
        double x, y, z;
    };
    /// A point of the base as it lies in space.
    struct Placed {
        double x, y, z;  ///< from the base's centre
        double stiffness;
        double depth;  ///< negative: away
    };

    /// Depth round a rim: middle + change cos(phi), phi from the horizontal direction towards its lowest point.
    struct RimDepth {
        double middle, change;
        double arc, sine, cosine;       ///< angle to where it leaves the ground
        std::array<double, 2> towards;  ///< along x and y
    };

    /// Stiffness of the points that touch, and its first and second moments over the base.
    struct BedMoments {
        double k, x, y, xx, xy, yy;
    };
    /// Of what touches of a continuous base, about the axis across the direction towards its lowest point.
    struct TouchingMoments {
        double k, x, xx, yy;
    };
    struct LeanStiffness {
        double xx, xy, yy;
    };
    /// Elastic yielding of the springs: slopes of the base along x and y, and displacement of the centre of gravity.
    struct Yielding {
        double slope_x, slope_y, x, y, rise;
    };

    void fill_trial(ContactAccuracy const& accuracy);
    void fill_waves();
    void fill_points();
    void place(SpatialStart const& start);
    void turn_by(std::array<double, 3> const& rotation_rad);
    void show_sample();
    void hold(std::size_t sample) { held_ = shaking_at(sample); }
    void wake();
    void fill_peaks(SpatialOutcome& out) const;
    void fill_landing(SpatialOutcome& out) const;
    void fill_verdict(SpatialOutcome& out) const;
    [[nodiscard]] bool fallen() const { return !(half_tilt_sine2() < 0.5); }
    [[nodiscard]] bool weak(std::size_t sample) const;
    [[nodiscard]] bool calm(std::size_t sample) const { return weak(sample) && weak(sample + 1); }
    [[nodiscard]] bool slipped() const;
    [[nodiscard]] bool sound() const;
    [[nodiscard]] double half_tilt_sine2() const;
    [[nodiscard]] double mechanical_energy() const;
    /// |a| / g_v at which the first point of the resting base parts, whatever the direction.
    [[nodiscard]] double parting_ratio() const;
    [[nodiscard]] Acceleration shaking_at(std::size_t sample) const;
    [[nodiscard]] std::array<double, 9> rotation() const;
    [[nodiscard]] std::array<double, 2> base_centre() const;
    [[nodiscard]] Placed placed(int point) const;
    [[nodiscard]] RimDepth rim_depth(double radius_m) const;
    [[nodiscard]] TouchingMoments segment(double radius_m) const;
    [[nodiscard]] TouchingMoments touching_moments() const;
    [[nodiscard]] BedMoments rim_moments() const;
    [[nodiscard]] BedMoments bed_moments() const;
    [[nodiscard]] double spring_energy() const;
    [[nodiscard]] LeanStiffness lean_stiffness(BedMoments const& bed) const;
    [[nodiscard]] Yielding yielding(BedMoments const& bed, Acceleration const& by) const;

    SpatialBlock const& block_;
    Acceleration held_{};  // shaking under which the body came to rest
};

}  // namespace overturn::spatial
