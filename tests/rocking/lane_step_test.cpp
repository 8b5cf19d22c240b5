// Requirement R-405: an impact, a peak or an energy that the lanes take without care is the step's own series' zero or
// highest, and friction and contact hold all along the step.
#include "rocking/detail/lane_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "rocking/detail/lane_run.hpp"

namespace overturn::rocking {
namespace {

// A step drawn at random: hard and soft landings, slow ones whose forcing changes more than the fall does, and steps
// that start with an impact.
class Draw {
  public:
    /// \param high anywhere up to 1.5 rad, else not far from landing
    [[nodiscard]] RockingFields<1> lane(std::array<double, 2> const& samples, bool high = false) {
        RockingFields<1> lane;
        auto const set = [&](RockingField field, double value) { lane.at(field, 0) = value; };
        double const alpha = between(0.05, 1.2);
        double const p = spread(0.5, 4);
        double const dt = spread(0.0025, 0.05);
        double const tau = coin() ? 0 : between(0, 0.99) * dt;
        double const e = between(0.2, 0.99);
        bool const started = coin();
        double const phi = started ? 0 : high ? between(0, 1.5) : spread(1e-12, 0.03);
        double const rate = (started || coin() ? 1 : -1) * spread(1e-9, 0.03);
        set(RockingField::phi, phi);
        set(RockingField::omega, rate / (dt - tau));
        set(RockingField::sine, std::sin(alpha - phi));
        set(RockingField::cosine, std::cos(alpha - phi));
        set(RockingField::side, 1);
        set(RockingField::tau, tau);
        set(RockingField::start, started ? 1 : 0);
        set(RockingField::peak, 10);
        set(RockingField::energy, unlimited);
        set(RockingField::demand, 0);
        set(RockingField::normal, unlimited);
        set(RockingField::p, p);
        set(RockingField::inverse_p, 1 / p);
        set(RockingField::r, 0.75 / (p * p));
        set(RockingField::inertia_ratio, 0.75);
        set(RockingField::restitution, e);
        set(RockingField::sine_alpha, std::sin(alpha));
        set(RockingField::cosine_alpha, std::cos(alpha));
        set(RockingField::uplift_ratio, std::tan(alpha));
        set(RockingField::incline_sine, 0);
        set(RockingField::incline_cosine, 1);
        set(RockingField::friction_limit, unlimited);
        set(RockingField::settle_speed, 1e-5 * p);
        set(RockingField::settle_rate, 2 / ((1 - e) * p * p * std::cos(alpha)));
        set(RockingField::tolerance, 1e-11 * alpha);
        set(RockingField::scale, 1);
        set(RockingField::time_step, dt);
        set(RockingField::sampling_rate, 1 / dt);
        set(RockingField::last, 5);
        lane.at(RockingWave::horizontal, 0) = samples.data();
        return lane;
    }
    [[nodiscard]] double between(double low, double high) {
        return std::uniform_real_distribution<>(low, high)(numbers_);
    }
    [[nodiscard]] std::array<double, 2> samples() {
        double const a = between(-1, 1) * spread(0.01, 1);
        return {a, a + between(-1, 1) * spread(0.001, 0.3)};
    }

    [[nodiscard]] double spread(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  private:
    bool coin() { return between(0, 1) < 0.5; }

    std::mt19937_64 numbers_{7};
};

// phi at a share of the step; after a start at zero, over the share.
long double height(LaneStep const& series, double phi, bool started, long double u) {
    long double sum = 0;
    for (int k = LaneStep::order - 1; k >= 0; --k) {
        sum = sum * u + static_cast<long double>(series.rates.at(k)) / (k + 1);
    }
    return started ? sum : phi + sum * u;
}

long double rotation(LaneStep const& series, double phi, bool started, long double u) {
    return height(series, phi, started, u) * (started ? u : 1);
}

// phi' length at a share of the step.
long double rate(LaneStep const& series, long double u) {
    long double sum = 0;
    for (int k = LaneStep::order - 1; k >= 0; --k) {
        sum = sum * u + static_cast<long double>(series.rates.at(k));
    }
    return sum;
}

struct Forces {
    double friction, normal;
};

// Contact forces over m g of a block that turns at `rate`, under a horizontal acceleration over g.
Forces forces(RockingFields<1> const& lane, double sine, double cosine, double rate, double a) {
    double const r = lane.at(RockingField::r, 0);
    double const p = lane.at(RockingField::p, 0);
    double const turn = -p * p * (sine + a * cosine);  // phi''
    double const spin = rate * rate;
    return {std::abs(r * (cosine * turn + sine * spin) + a), r * (sine * turn - cosine * spin) + 1};
}

TEST(LaneStep, ImpactsLieOnTheSeries) {
    Draw draw;
    int impacts = 0;
    int refused = 0;
    for (int i = 0; i < 200000; ++i) {
        auto const samples = draw.samples();
        auto lane = draw.lane(samples);
        auto const before = lane;
        LaneStep series;
        (void)step_lane_once(lane, false, series);
        bool const started = before.at(RockingField::start, 0) > 0;
        refused += lane.at(RockingField::steps, 0) == 0 ? 1 : 0;
        if (lane.at(RockingField::impacts, 0) == 0) {
            continue;
        }
        ++impacts;
        constexpr long double aside = 1e-13L;  // of the share
        long double const u = series.share;
        double const phi = before.at(RockingField::phi, 0);
        EXPECT_GT(height(series, phi, started, u * (1 - aside)), 0) << "draw " << i;
        EXPECT_LT(height(series, phi, started, u * (1 + aside)), 0) << "draw " << i;

        // What the corner carries, and the friction it needs, is looked at here and just before the impact.
        auto const before_sine = before.at(RockingField::sine, 0);
        auto const before_cosine = before.at(RockingField::cosine, 0);
        auto const s = before.at(RockingField::sine_alpha, 0);
        auto const c = before.at(RockingField::cosine_alpha, 0);
        double const omega = before.at(RockingField::omega, 0);
        double const landing = lane.at(RockingField::omega, 0) / before.at(RockingField::restitution, 0);
        auto const start = forces(before, before_sine, before_cosine, omega, series.horizontal[0]);
        auto const end = forces(before, s, c, landing, series.horizontal[0] + series.share * series.horizontal[1]);
        double const least = std::min(start.normal, end.normal);
        EXPECT_NEAR(lane.at(RockingField::normal, 0), least, 1e-12 * (1 + std::abs(end.normal))) << "draw " << i;
        double const needs = std::max(start.friction / start.normal, end.friction / end.normal);
        EXPECT_NEAR(lane.at(RockingField::demand, 0), needs, 1e-11 * (1 + needs)) << "draw " << i;
    }
    EXPECT_GT(impacts, 50000);
    EXPECT_LT(refused, impacts) << "most impacts are the lanes' own";
}

// The highest value of a function over [0, end]: the best of many points, then ever closer around it.
template <class Function> long double highest(Function const& f, long double end) {
    constexpr int points = 64;
    long double best = 0;
    for (int i = 1; i <= points; ++i) {
        best = f(end * i / points) > f(best) ? end * i / points : best;
    }
    long double low = std::max(0.0L, best - end / points);
    long double high = std::min(end, best + end / points);
    constexpr int thirds = 60;
    for (int i = 0; i < thirds; ++i) {
        long double const a = low + (high - low) / 3;
        long double const b = high - (high - low) / 3;
        (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
    }
    return std::max({f(0.0L), f(0.5L * (low + high)), f(end)});
}

// Peaks before the step: just here, and a little above what is reached from here.
void expect_highest(bool vertical, double off) {
    Draw draw;
    int crests = 0;
    int summits = 0;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        auto const samples = draw.samples();
        auto const vertical_samples = draw.samples();
        auto lane = draw.lane(samples, i % 4 > 1);
        lane.at(RockingWave::vertical, 0) = vertical_samples.data();
        double const phi = lane.at(RockingField::phi, 0);
        double const reach = std::abs(lane.at(RockingField::omega, 0)) * lane.at(RockingField::time_step, 0);
        lane.at(RockingField::peak, 0) = i % 2 == 0 ? phi : phi + draw.between(0, 0.5) * reach;
        lane.at(RockingField::energy, 0) = 0;
        auto const before = lane;
        LaneStep series;
        (void)step_lane_once(lane, vertical, series);
        if (lane.at(RockingField::steps, 0) == 0) {
            continue;
        }
        bool const started = before.at(RockingField::start, 0) > 0;
        auto const turned = [&](long double u) { return rotation(series, phi, started, u); };
        auto const energy = [&](long double u) {
            long double const alpha = std::acos(static_cast<long double>(before.at(RockingField::cosine_alpha, 0)));
            long double const spread =
                rate(series, u) / (before.at(RockingField::p, 0) * static_cast<long double>(series.length_s));
            return 0.5L * spread * spread + std::cos(alpha - turned(u)) - std::cos(alpha);
        };
        long double const share = series.share;
        long double const top = highest(turned, share);
        long double const most = highest(energy, share);
        double const peak = std::max(before.at(RockingField::peak, 0), static_cast<double>(top));
        EXPECT_NEAR(lane.at(RockingField::peak, 0), peak, 1e-14 * peak) << "draw " << i;
        crests += top > std::max<long double>(turned(share), before.at(RockingField::peak, 0)) * (1 + 1e-9L) ? 1 : 0;
        // Of the energy every step raises what it starts with; what it ends with is the next one's.
        long double const ends = std::max(energy(0), lane.at(RockingField::impacts, 0) > 0 ? energy(share) : 0);
        if (most > std::max({ends, energy(share), 0.0L}) * (1 + 1e-6L)) {
            ++summits;
            worst = std::max(worst, static_cast<double>(std::abs(lane.at(RockingField::energy, 0) - most)));
        } else {
            EXPECT_GE(lane.at(RockingField::energy, 0), ends - off) << "draw " << i;
            EXPECT_LE(lane.at(RockingField::energy, 0), std::max(most, 0.0L) + off) << "draw " << i;
        }
    }
    EXPECT_GT(crests, 1000);
    EXPECT_GT(summits, 1000);
    EXPECT_LT(worst, off);
}

// Friction that would just do at the start of a step, or a little more, and what is needed all along it.
TEST(LaneStep, StepsTakenHoldAllAlong) {
    Draw draw;
    int taken = 0;
    for (int i = 0; i < 60000; ++i) {
        auto const samples = draw.samples();
        auto lane = draw.lane(samples, i % 2 == 0);
        double const a =
            samples[0]
            + (samples[1] - samples[0]) * lane.at(RockingField::tau, 0) * lane.at(RockingField::sampling_rate, 0);
        auto const start = forces(lane, lane.at(RockingField::sine, 0), lane.at(RockingField::cosine, 0),
                                  lane.at(RockingField::omega, 0), a);
        double const limit = start.friction / start.normal * (1 + draw.spread(1e-6, 0.3));
        if (!(start.normal > 0)) {
            continue;
        }
        lane.at(RockingField::friction_limit, 0) = limit;
        lane.at(RockingField::impact_demand, 0) = 0;
        auto const before = lane;
        LaneStep series;
        (void)step_lane_once(lane, false, series);
        if (lane.at(RockingField::steps, 0) == 0) {
            continue;
        }
        ++taken;
        double const alpha = std::acos(before.at(RockingField::cosine_alpha, 0));
        bool const started = before.at(RockingField::start, 0) > 0;
        constexpr int points = 32;
        for (int k = 0; k <= points; ++k) {
            double const u = series.share * k / points;
            auto const phi = static_cast<double>(rotation(series, before.at(RockingField::phi, 0), started, u));
            auto const omega = static_cast<double>(rate(series, u)) / series.length_s;
            auto const now = forces(before, std::sin(alpha - phi), std::cos(alpha - phi), omega,
                                    series.horizontal[0] + u * series.horizontal[1]);
            ASSERT_GT(now.normal, 0) << "draw " << i;
            ASSERT_LE(now.friction, limit * now.normal * (1 + 1e-12)) << "draw " << i;
        }
    }
    EXPECT_GT(taken, 5000);
}

TEST(LaneStep, PeaksAndEnergiesAreTheSeriesHighest) { expect_highest(false, 1e-15); }
TEST(LaneStep, PeaksAndEnergiesUnderVerticalMotionToo) { expect_highest(true, 1e-10); }

}  // namespace
}  // namespace overturn::rocking
