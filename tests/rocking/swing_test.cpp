// Requirement: an impact that the lanes take without care lies where the step's own series is zero.
#include "rocking/swing.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "rocking/rocking_swing.hpp"

namespace overturn::rocking {
namespace {

// A step drawn at random: hard and soft landings, slow ones whose forcing changes more than the fall does, and steps
// that start with an impact.
class Draw {
  public:
    [[nodiscard]] SwingLanes<1> lane(std::array<double, 2> const& samples) {
        SwingLanes<1> lane;
        auto const set = [&](Swing field, double value) { lane.at(field, 0) = value; };
        double const alpha = between(0.05, 1.2);
        double const p = spread(0.5, 4);
        double const dt = spread(0.0025, 0.05);
        double const tau = coin() ? 0 : between(0, 0.99) * dt;
        double const e = between(0.2, 0.99);
        bool const started = coin();
        double const phi = started ? 0 : spread(1e-12, 0.03);
        double const rate = (started || coin() ? 1 : -1) * spread(1e-9, 0.03);
        set(Swing::phi, phi);
        set(Swing::omega, rate / (dt - tau));
        set(Swing::sine, std::sin(alpha - phi));
        set(Swing::cosine, std::cos(alpha - phi));
        set(Swing::side, 1);
        set(Swing::tau, tau);
        set(Swing::start, started ? 1 : 0);
        set(Swing::peak, 10);
        set(Swing::energy, unlimited);
        set(Swing::demand, unlimited);
        set(Swing::normal, -unlimited);
        set(Swing::p, p);
        set(Swing::inverse_p, 1 / p);
        set(Swing::r, 0.75 / (p * p));
        set(Swing::inertia_ratio, 0.75);
        set(Swing::restitution, e);
        set(Swing::sine_alpha, std::sin(alpha));
        set(Swing::cosine_alpha, std::cos(alpha));
        set(Swing::uplift_ratio, std::tan(alpha));
        set(Swing::friction_limit, unlimited);
        set(Swing::settle_speed, 1e-5 * p);
        set(Swing::settle_rate, 2 / ((1 - e) * p * p * std::cos(alpha)));
        set(Swing::tolerance, 1e-11 * alpha);
        set(Swing::scale, 1);
        set(Swing::time_step, dt);
        set(Swing::sampling_rate, 1 / dt);
        set(Swing::last, 5);
        set(Swing::samples, address_of(samples.data()));
        return lane;
    }
    [[nodiscard]] std::array<double, 2> samples() {
        double const a = between(-1, 1) * spread(0.01, 1);
        return {a, a + between(-1, 1) * spread(0.001, 0.3)};
    }

  private:
    double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(numbers_); }
    double spread(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    bool coin() { return between(0, 1) < 0.5; }

    std::mt19937_64 numbers_{7};
};

// phi at a share of the step; after a start at zero, over the share.
long double height(SwingSeries const& series, double phi, bool started, long double u) {
    long double sum = 0;
    for (int k = SwingSeries::order - 1; k >= 0; --k) {
        sum = sum * u + static_cast<long double>(series.rates.at(k)) / (k + 1);
    }
    return started ? sum : phi + sum * u;
}

TEST(Swing, ImpactsLieOnTheSeries) {
    Draw draw;
    int impacts = 0;
    int refused = 0;
    for (int i = 0; i < 200000; ++i) {
        auto const samples = draw.samples();
        auto lane = draw.lane(samples);
        auto const before = lane;
        SwingSeries series;
        (void)swing_once(lane, false, series);
        bool const started = before.at(Swing::start, 0) > 0;
        refused += lane.at(Swing::steps, 0) == 0 ? 1 : 0;
        if (lane.at(Swing::impacts, 0) == 0) {
            continue;
        }
        ++impacts;
        constexpr long double aside = 1e-13L;  // of the share
        long double const u = series.share;
        double const phi = before.at(Swing::phi, 0);
        EXPECT_GT(height(series, phi, started, u * (1 - aside)), 0) << "draw " << i;
        EXPECT_LT(height(series, phi, started, u * (1 + aside)), 0) << "draw " << i;
    }
    EXPECT_GT(impacts, 50000);
    std::printf("%d impacts, %d steps left to care\n", impacts, refused);
}

}  // namespace
}  // namespace overturn::rocking
