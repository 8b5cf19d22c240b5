// Requirement R-504: motion in space keeps the contract of models: it holds what it says, fills outcomes and own
// fields, and is called for by a base or a second component that no plane holds.
#include "spatial/spatial_model.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "contact/matching.hpp"
#include "spatial/cases.hpp"
#include "support/bit_equal.hpp"
#include "support/describe_all.hpp"

namespace overturn {
namespace {

using testing::body_a;
using testing::polygon_base;
using testing::round_base;
using testing::square_base;

constexpr EffectMask spatial = mask_of(Effect::spatial);
constexpr EffectMask all = mask_of(Effect::vertical) | mask_of(Effect::sliding) | mask_of(Effect::contact) | spatial;

Footing unmatched(Footing footing) {
    footing.pad.match_restitution = false;
    return footing;
}

TEST(SpatialModel, SaysWhatItIs) {
    auto const& traits = spatial_traits();
    EXPECT_EQ(traits.name, "spatial");
    EXPECT_EQ(traits.number, 4);
    EXPECT_EQ(traits.holds, all);
    EXPECT_EQ(traits.always, mask_of(Effect::contact) | spatial);
    EXPECT_EQ(traits.brings(), spatial);
    EXPECT_TRUE(testing::describe_all(traits.fields, traits.default_row.size()));
    EXPECT_TRUE(std::isnan(real_at(traits.default_row, field_named(traits.fields, "peak_yaw"))));
}

/// Counts what it is shown.
struct Seen : Observer {
    void begin(std::span<Channel const> /*channels*/) override { ++begun; }
    void at(std::span<double const> values) override {
        width = values.size();
        finite = finite && std::isfinite(values[1] + values[5] + values[9]);
        ++instants;
    }
    int begun = 0, instants = 0;
    std::size_t width = 0;
    bool finite = true;
};

// Whoever asks for a history begins it, with the channels that the traits name.
TEST(SpatialModel, ShowsTheChannelsThatItNames) {
    auto const wave = testing::sine(1, 1, 1, 2, 0.01);
    auto const body = body_a();
    auto const footing = unmatched(round_base());
    Trial const trial{&body,
                      &footing,
                      {},
                      {.horizontal_mps2 = wave, .transverse_mps2 = wave, .time_step_s = 0.01, .scale = 6},
                      spatial};
    Outcome outcome;
    Seen seen;
    (void)make_spatial_model({})->run(
        {.trials = std::span(&trial, 1), .outcomes = std::span(&outcome, 1), .observer = &seen});
    EXPECT_EQ(seen.begun, 0);
    EXPECT_GT(seen.instants, 10);
    EXPECT_TRUE(seen.finite);
    EXPECT_EQ(seen.width, spatial_traits().channels.size());
    EXPECT_EQ(outcome.required, spatial);
}

// R-1002.
TEST(SpatialModel, RunsABatchAsItsTrialsAlone) {
    auto const wave = testing::sine(1, 1, 1, 2, 0.01);
    auto const across = testing::sine(0.6, 1.5, 2, 5.0 / 3, 0.01);
    auto const body = body_a();
    auto const footing = unmatched(round_base());
    auto const model = make_spatial_model({});
    std::vector<Trial> trials;
    for (double const level : {3.0, 7.0, 9.0, 14.0}) {
        for (EffectMask const simulated : {spatial, all}) {
            trials.push_back({&body,
                              &footing,
                              Friction{0.5, 0.4},
                              {.horizontal_mps2 = wave,
                               .transverse_mps2 = across,
                               .vertical_mps2 = wave,
                               .time_step_s = 0.01,
                               .scale = level},
                              simulated});
        }
    }
    std::vector<Outcome> outcomes(trials.size());
    std::vector<std::byte> own(trials.size() * sizeof(SpatialQuantities));
    model->run({.trials = trials, .outcomes = outcomes, .extra = own});
    for (std::size_t i = 0; i < trials.size(); ++i) {
        bool const everything = trials[i].simulated == all;
        auto const block = spatial_block(body, footing, everything ? trials[i].friction : std::nullopt);
        auto shaking = trials[i].excitation;
        shaking.vertical_mps2 = everything ? shaking.vertical_mps2 : std::span<double const>{};
        auto alone = simulate_spatial(block, shaking);
        alone.required = spatial;
        EXPECT_TRUE(testing::bit_equal<Outcome>(alone, outcomes[i])) << i;
        alone.extra.restitution = emergent_restitution(body, footing.base, footing.pad);
        alone.extra.normal_restitution = 0.25;
        SpatialQuantities row;
        std::memcpy(&row, own.data() + i * sizeof(row), sizeof(row));
        EXPECT_TRUE(testing::bit_equal(alone.extra, row)) << i;
    }
}

//
TEST(SpatialModel, MatchesASquareBaseAsThePlanarOne) {
    auto const wave = testing::sine(8, 1, 1, 2, 0.01);
    RigidBody const body({.mass_kg = 12.6e3,
                          .half_width_m = 0.68,
                          .centre_height_m = 1.045,
                          .inertia_kgm2 = body_a().inertia_kgm2(),
                          .restitution = 0.7});
    Footing const on_corners;
    Trial const trial{&body, &on_corners, {}, {.horizontal_mps2 = wave, .time_step_s = 0.01}, spatial};
    Outcome outcome;
    make_spatial_model({})->run({.trials = {&trial, 1}, .outcomes = {&outcome, 1}});
    auto const match = match_restitution(body, {}, {});
    auto footing = square_base(*match.base.corner_share, match.base.points);
    footing.pad.normal_restitution = match.pad.normal_restitution;
    EXPECT_EQ(outcome.peak_rotation_rad,
              simulate_spatial(spatial_block(body, footing, {}), trial.excitation).peak_rotation_rad);
    EXPECT_LT(match.base.corner_share, 0.5);
}

TEST(SpatialModel, IsCalledForWhereNoPlaneHolds) {
    auto const body = body_a();
    auto const called = [&](Footing const& footing, double x, double y, double z = 0,
                            std::optional<Friction> const& friction = {}) {
        std::vector<double> const along{0, x};
        std::vector<double> const across{0, y};
        std::vector<double> const up{0, z};
        Trial const trial{&body,
                          &footing,
                          friction,
                          {.horizontal_mps2 = along,
                           .transverse_mps2 = y == 0 ? std::span<double const>{} : across,
                           .vertical_mps2 = up,
                           .time_step_s = 0.01,
                           .scale = -2}};
        auto const call = make_spatial_model({})->required_of(trial, nullptr);
        EXPECT_EQ(call.effects == 0, call.reason == no_reason);
        EXPECT_EQ(has(call.effects, Effect::sliding), call.effects != 0 && friction.has_value());
        return has(call.effects, Effect::spatial) && has(call.effects, Effect::contact);
    };
    auto const triangle = polygon_base({{0.6, 0}, {-0.4, 0.6}, {-0.4, -0.6}});
    EXPECT_TRUE(called(triangle, 1, 0.1));
    EXPECT_TRUE(called(triangle, 1, 0));
    EXPECT_TRUE(called(round_base(), 1, 1e-9));
    EXPECT_TRUE(called(round_base(), 1, 0));
    EXPECT_TRUE(called(round_base(32), 1, 1e-9));
    EXPECT_FALSE(called(round_base(32), 100, 0));

    double const uplift = body.uplift_acceleration_mps2() / 2;  // levels are doubled
    EXPECT_FALSE(called(square_base(), 100, 0));
    EXPECT_FALSE(called(square_base(), 100, 0.59 * uplift));
    EXPECT_TRUE(called(square_base(), 0, 0.61 * uplift));
    EXPECT_TRUE(called(square_base(), 0, -0.61 * uplift));
    EXPECT_TRUE(called(square_base(), 0, 0.31 * uplift, 0.25 * g0));  // half of the weight is lifted off
    EXPECT_FALSE(called(square_base(), 0, 0.31 * uplift, -0.25 * g0));

    Friction const friction{0.4, 0.3};
    double const grip = 0.3 * g0 / 2;
    EXPECT_FALSE(called(square_base(), 0.9 * grip, 0.4 * grip, 0, friction));
    EXPECT_TRUE(called(square_base(), 0.9 * grip, 0.45 * grip, 0, friction));
    EXPECT_TRUE(called(square_base(), 1.1 * grip, 0.45 * grip, 0, friction));
    EXPECT_FALSE(called(square_base(), 1.1 * grip, 0.09 * grip, 0, friction));
    EXPECT_FALSE(called(square_base(), 0.9 * grip, 0.45 * grip));
}

}  // namespace
}  // namespace overturn
