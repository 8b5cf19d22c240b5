// Requirement: in free motion of 10^5 s energy never grows, in any model, with losses and without.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "contact/cases.hpp"
#include "rocking/planar_rocking.hpp"
#include "spatial/cases.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::round_base;
using testing::square_base;
using testing::standing;

constexpr double day_s = 1e5;  // and some hours more
constexpr std::size_t parts = 20;

/// The largest energy in each part of the time.
class Largest {
  public:
    explicit Largest(double longest_s) : longest_s_(longest_s) {}
    void hold(double time_s, double energy) {
        auto const part = static_cast<std::size_t>(time_s / longest_s_ * parts);
        if (part < parts) {
            of_[part] = std::max(of_[part], energy);
        }
        ++instants_;
    }
    /// \param share of the first part's largest that the arithmetic may give back within a part
    void expect_no_growth(double share) const {
        ASSERT_GT(instants_, longest_s_);
        ASSERT_GT(of_.front(), 0);
        for (std::size_t i = 1; i < parts; ++i) {
            EXPECT_LE(of_[i], of_[i - 1] + share * of_.front()) << "part " << i << " of " << parts;
        }
    }
    [[nodiscard]] double kept() const { return of_.back() / of_.front(); }

  private:
    double longest_s_;
    std::array<double, parts> of_{};
    std::size_t instants_ = 0;
};

std::vector<double> calm(double longest_s, double step_s) {
    return std::vector<double>(static_cast<std::size_t>(longest_s / step_s) + 1, 0.0);
}

struct RigidEnergy : RockingObserver {
    RigidEnergy(RockingBlock const& of, double longest_s) : block(of), largest(longest_s) {}
    void at(RockingInstant const& i) override {
        double const lift = std::cos(block.alpha_rad - std::abs(i.rotation_rad)) - std::cos(block.alpha_rad);
        double const spin = i.velocity_radps / block.p_radps;
        largest.hold(i.time_s, 0.5 * spin * spin + lift);
    }
    RockingBlock block;
    Largest largest;
};

// Without loss, so that it rocks on: 10^5 impacts and more. Steps of 0.1 s, a third of 1 / p, give 3e-11 at each of
// them.
TEST(FreeMotion, ARigidBodyGainsNothing) {
    RockingBlock const block{.alpha_rad = 0.25, .p_radps = 3, .restitution = 1};
    RigidEnergy seen(block, day_s);
    auto const wave = calm(day_s, 0.01);
    auto const out = simulate_rocking(block, {.horizontal_mps2 = wave, .time_step_s = 0.01}, {},
                                      {.rotation_rad = 0.5 * block.alpha_rad}, &seen);

    EXPECT_GT(out.impacts, 100'000);
    seen.largest.expect_no_growth(1e-12);
    EXPECT_NEAR(seen.largest.kept(), 1, 1e-11);
}

struct PlanarEnergy : ContactObserver {
    PlanarEnergy(ContactBlock const& of, double longest_s) : block(of), largest(longest_s) {}
    void at(ContactInstant const& i) override {
        // what springs hold comes on top: none where they hold no more than at rest
        largest.hold(i.time_s, 0.5
                                       * (i.sway_mps * i.sway_mps + i.rise_mps * i.rise_mps
                                          + block.inertia_over_mass_m2 * i.velocity_radps * i.velocity_radps)
                                   + block.gravity_mps2 * (i.rise_m + block.settlement_m()));
    }
    ContactBlock block;
    Largest largest;
};

struct SpatialEnergy : SpatialObserver {
    explicit SpatialEnergy(double longest_s) : largest(longest_s) {}
    void at(SpatialInstant const& i) override { largest.hold(i.time_s, i.energy_jpkg); }
    Largest largest;
};

constexpr double step_s = 0.1;
constexpr ContactAccuracy unheld{.longest_after_s = 0, .rest_gate = false};

/// From leaning, on pads that give back all or as usual.
void planar_gains_nothing(double longest_s) {
    for (double const normal : {1.0, 0.25}) {
        auto const block = testing::on_corners(
            body_a(), 0.8, {.normal_restitution = normal, .tangential_damping = 1e-9, .match_restitution = false});
        PlanarEnergy seen(block, longest_s);
        auto const out =
            testing::shaken(block, calm(longest_s, step_s), step_s, unheld, &seen,
                            leaning_start(block, 0.5 * std::atan2(block.half_width_m, block.centre_height_m)));

        seen.largest.expect_no_growth(1e-9);
        EXPECT_EQ(out.failure, FailureReason::none);
        EXPECT_LT(seen.largest.kept(), 1e-4) << "it comes to rest, by friction alone where pads give back all";
    }
}

// Leaning on its lowest point, which just touches, and turning.
SpatialStart leaning(SpatialBlock const& block, double tilt_rad) {
    double const h = block.planar.centre_height_m;
    double const b = block.planar.half_width_m;
    return {.x_m = b * (1 - std::cos(tilt_rad)) + h * std::sin(tilt_rad),
            .rise_m = b * std::sin(tilt_rad) - h * (1 - std::cos(tilt_rad)) + block.planar.settlement_m(),
            .rotation_rad = {0, tilt_rad, 0},
            .angular_velocity_radps = {0.1, 0, 0.3}};
}

/// Without loss but of friction: a square base comes to lie, a rim rolls on.
void spatial_gains_nothing(double longest_s) {
    for (auto footing : {square_base(), round_base()}) {
        footing.pad.normal_restitution = 1;
        footing.pad.tangential_damping = 1e-9;
        footing.pad.match_restitution = false;
        auto const block = standing(body_a(), footing, 0.8);
        SpatialEnergy seen(longest_s);
        auto const wave = calm(longest_s, step_s);
        auto const out =
            testing::shaken(block, {wave, testing::Shaking::nothing(), step_s}, unheld, &seen, leaning(block, 0.1));

        seen.largest.expect_no_growth(1e-9);
        EXPECT_EQ(out.failure, FailureReason::none);
        EXPECT_EQ(seen.largest.kept() > 0.3, footing.base.shape == BaseShape::round) << seen.largest.kept();
    }
}

TEST(FreeMotion, ABodyOnPointsGainsNothing) { planar_gains_nothing(8000); }
TEST(FreeMotion, ABodyInSpaceGainsNothing) { spatial_gains_nothing(2000); }

// Minutes of computing: by hand.
TEST(FreeMotion, DISABLED_NorForADay) {
    planar_gains_nothing(day_s);
    spatial_gains_nothing(day_s);
}

}  // namespace
}  // namespace overturn
