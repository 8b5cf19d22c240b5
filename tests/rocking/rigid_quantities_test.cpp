// Requirement R-713: to which side a rigid body rotated farthest, and how far its top went.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/rocking_models.hpp"
#include "support/sliding_blocks.hpp"

namespace overturn {
namespace {

RigidBody cask(double offset_m = 0) {
    double const mass = 12.6e3;
    return RigidBody({.mass_kg = mass,
                      .half_width_m = 0.45,
                      .centre_height_m = 1.045,
                      .inertia_kgm2 = mass * (0.45 * 0.45 + 1.045 * 1.045) / 3,
                      .offset_m = offset_m});
}

// The farthest that a history of a trial shows.
class Extremes : public Observer {
  public:
    explicit Extremes(RigidBody const& body) : body_(body) {}
    void begin(std::span<Channel const> /*channels*/) override {}
    void at(std::span<double const> values) override {
        double const rotation = values[1];
        double const slip = values[5];
        double const theta = std::abs(rotation);
        double const tilt =
            body_.half_width_m() * (1 - std::cos(theta)) + 2 * body_.centre_height_m() * std::sin(theta);
        top_m = std::max(top_m, std::abs(slip + std::copysign(tilt, rotation)));
        if (theta > std::abs(rotation_rad)) {
            rotation_rad = rotation;
        }
    }
    double top_m = 0, rotation_rad = 0;

  private:
    RigidBody const& body_;
};

struct Seen {
    Outcome outcome;
    RigidQuantities extra;
    double shown_top_m = 0, shown_rotation_rad = 0;
};

Seen seen(RigidBody const& body, std::vector<double> const& wave, std::optional<Friction> friction = {}) {
    Footing const footing;
    std::array const trials{
        Trial{.body = &body, .footing = &footing, .friction = friction, .excitation = testing::shaking_of(wave, 0.02)}};
    auto const model = friction ? make_sliding_model({}) : make_rocking_model({});
    Extremes extremes(body);
    std::array<Outcome, 1> outcomes;
    (void)model->run({.trials = trials, .outcomes = outcomes, .observer = &extremes});
    Seen all{.outcome = {}, .extra = {}, .shown_top_m = extremes.top_m, .shown_rotation_rad = extremes.rotation_rad};
    outcomes = {};
    (void)model->run(
        {.trials = trials, .outcomes = outcomes, .extra = std::as_writable_bytes(std::span(&all.extra, 1))});
    all.outcome = outcomes[0];
    return all;
}

std::vector<double> scaled(std::vector<double> wave, double factor) {
    std::ranges::transform(wave, wave.begin(), [factor](double a) { return factor * a; });
    return wave;
}

// A history shows where steps begin: a peak within a step is a little higher.
void expect_near_history(Seen const& of) {
    EXPECT_GT(of.extra.rotation_at_peak_rad * of.shown_rotation_rad, 0);
    EXPECT_EQ(std::abs(of.extra.rotation_at_peak_rad), of.outcome.peak_rotation_rad);
    EXPECT_NEAR(of.extra.rotation_at_peak_rad, of.shown_rotation_rad,
                of.outcome.verdict == Verdict::overturned ? 0.05 : 2e-3);
}

TEST(RigidQuantities, AreThoseOfEveryInstant) {
    auto const body = cask();
    int to_the_left = 0;
    int to_the_right = 0;
    for (int number = 1; number <= 12; ++number) {
        auto const wave = scaled(testing::short_wave(number), 5);
        auto const of = seen(body, wave);
        expect_near_history(of);
        if (of.outcome.verdict == Verdict::overturned) {
            continue;
        }
        EXPECT_GE(of.extra.peak_top_m, of.shown_top_m) << number;
        EXPECT_NEAR(of.extra.peak_top_m, of.shown_top_m, 4e-3) << number;
        ++(of.extra.rotation_at_peak_rad > 0 ? to_the_right : to_the_left);
    }
    EXPECT_GT(to_the_left, 2);
    EXPECT_GT(to_the_right, 2);
}

// The largest slip and the largest rotation at once: no less than what the body does, and the top of one that only
// slides goes as far as its base.
TEST(RigidQuantities, TopOfASlidingBodyIsNoLessThanItWent) {
    auto const body = cask();
    int slid = 0;
    for (int number = 1; number <= 6; ++number) {
        auto const of = seen(body, scaled(testing::short_wave(number), 5.5), Friction{0.45, 0.42});
        if (of.outcome.verdict == Verdict::overturned) {
            continue;
        }
        ASSERT_GT(of.outcome.peak_slip_m, 0) << number;
        EXPECT_GE(of.extra.peak_top_m, of.shown_top_m) << number;
        ++slid;
    }
    EXPECT_GT(slid, 2);
    auto const low = seen(body, scaled(testing::short_wave(1), 5.5), Friction{0.2, 0.2});
    EXPECT_EQ(low.extra.peak_top_m, low.outcome.peak_slip_m);
    EXPECT_EQ(low.extra.rotation_at_peak_rad, 0);
}

// A push just long enough: the body falls slowly and keeps its corner on the ground. Then the top lies its height and
// half the base from where it stood. Shaken so hard that it flies, it is known to which side it fell, not where its top
// lay.
TEST(RigidQuantities, AFallLaysTheTopDown) {
    auto const body = cask();
    Seen pushed;
    for (std::size_t samples = 10; samples < 200 && pushed.outcome.verdict != Verdict::overturned; ++samples) {
        std::vector<double> wave(400, 0.0);
        std::fill_n(wave.begin(), samples, 5.0);
        pushed = seen(body, wave);
    }
    ASSERT_EQ(pushed.outcome.verdict, Verdict::overturned);
    ASSERT_TRUE(std::isnan(pushed.outcome.contact_lost_s));
    EXPECT_EQ(pushed.extra.rotation_at_peak_rad, -pi / 2) << "away from where the ground goes";
    EXPECT_NEAR(pushed.extra.peak_top_m, body.half_width_m() + 2 * body.centre_height_m(), 1e-12);
    auto const flies = seen(body, scaled(testing::short_wave(3), 12));
    ASSERT_EQ(flies.outcome.verdict, Verdict::overturned);
    ASSERT_FALSE(std::isnan(flies.outcome.contact_lost_s));
    EXPECT_TRUE(std::isnan(flies.extra.peak_top_m));
    expect_near_history(flies);
}

// The mirrored wave: the same bits to the other side, for a fall too.
TEST(RigidQuantities, AreMirroredWithTheWave) {
    auto const body = cask();
    int known = 0;
    for (double const factor : {5.5, 12.0}) {
        auto const wave = scaled(testing::short_wave(3), factor);
        auto const one = seen(body, wave).extra;
        auto const other = seen(body, testing::mirrored(wave)).extra;
        EXPECT_NE(one.rotation_at_peak_rad, 0) << factor;
        EXPECT_EQ(one.rotation_at_peak_rad, -other.rotation_at_peak_rad) << factor;
        EXPECT_EQ(std::isnan(one.peak_top_m), std::isnan(other.peak_top_m)) << factor;
        if (!std::isnan(one.peak_top_m)) {
            EXPECT_EQ(one.peak_top_m, other.peak_top_m) << factor;
            ++known;
        }
    }
    EXPECT_EQ(known, 1);
}

// Of unlike corners the one nearer to falling is the peak; the other one may move the top farther.
TEST(RigidQuantities, TopOfUnlikeCornersIsNoLessThanItWent) {
    for (double const offset : {-0.1, 0.1}) {
        auto const body = cask(offset);
        for (int number = 1; number <= 6; ++number) {
            auto const of = seen(body, scaled(testing::short_wave(number), 4.5));
            if (of.outcome.verdict != Verdict::overturned) {
                EXPECT_GE(of.extra.peak_top_m, of.shown_top_m) << offset << ' ' << number;
            }
        }
    }
}

}  // namespace
}  // namespace overturn
