// Requirement: the ranges of amplitude that overturn a block under a pulse, with an impact and without,
// and the gaps of survival between them are those of the closed forms of Zhang and Makris (2001) and Shi et al. (1996).
#include "rocking/overturning_search.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

constexpr double alpha = 0.25;
constexpr double p = 2.0;
constexpr double g_alpha = alpha * g0;
// Chords miss the sine by (pi/2000)^2/8 = 3e-7 at most.
constexpr testing::Tolerance sampled{1e-6, "sampled_sine"};

OverturningRanges under_sine(int halves, double w, Restoring restoring, double e = 0.9) {
    constexpr int samples = 2000;
    std::vector<double> pulse(samples * halves + 1);
    for (std::size_t i = 0; i < pulse.size(); ++i) {
        pulse[i] = g_alpha * std::sin(pi * static_cast<double>(i) / samples);
    }
    pulse.back() = 0;
    RockingBlock const block{.alpha_rad = alpha, .p_radps = p, .restitution = e};
    return overturning_ranges(block, {.horizontal_mps2 = pulse, .time_step_s = pi / (w * p) / samples},
                              {.highest = 12, .step = 0.03, .accuracy = {.restoring = restoring}});
}

double root(double low, double high, std::function<double(double)> const& f) {
    bool const rises = f(high) > 0;
    for (int i = 0; i < 200; ++i) {
        double const middle = 0.5 * (low + high);
        ((f(middle) > 0) == rises ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

// The linearised block under n sin(w t), n over g alpha, time in 1/p: closed form between impacts, phi = theta/alpha.
// Nothing of the program's integration.
class LinearBlock {
  public:
    LinearBlock(double n, double w, double e) : n_(n), w_(w), e_(e), end_(2 * pi / w) {}

    struct End {
        bool fell;
        int impacts;
    };
    [[nodiscard]] End run() {
        t_ = std::asin(1 / n_) / w_;
        while (phi_ * side_ < far) {
            double const hit = next_impact();
            if (!(hit < end_)) {
                auto const [phi, velocity] = state_at(end_);
                return fate(phi, velocity);
            }
            velocity_ = e_ * state_at(hit).velocity;
            phi_ = 0;
            t_ = hit;
            side_ = -side_;
            ++impacts_;
        }
        return {true, impacts_};
    }

  private:
    static constexpr double far = 1e3;

    struct State {
        double phi, velocity;
    };
    [[nodiscard]] double forced(double t) const { return n_ / (1 + w_ * w_) * std::sin(w_ * t); }
    [[nodiscard]] double forced_rate(double t) const { return n_ * w_ / (1 + w_ * w_) * std::cos(w_ * t); }
    [[nodiscard]] State state_at(double t) const {
        double const a = phi_ - side_ - forced(t_);
        double const b = velocity_ - forced_rate(t_);
        double const c = std::cosh(t - t_);
        double const s = std::sinh(t - t_);
        return {side_ + a * c + b * s + forced(t), a * s + b * c + forced_rate(t)};
    }
    // The first time at which the rotation changes its side, or the pulse's end.
    [[nodiscard]] double next_impact() const {
        constexpr double step = 1e-3;
        for (double t = t_ + 1e-9; t < end_; t += step) {
            if (side_ * state_at(t + step).phi < 0 && side_ * state_at(t).phi >= 0) {
                return root(t, t + step, [&](double at) { return state_at(at).phi; });
            }
        }
        return end_;
    }
    // No shaking any more: it falls where the growing part points outwards, else it comes back and may fall beyond.
    [[nodiscard]] End fate(double phi, double velocity) const {
        double const outwards = side_ * (phi + velocity) - 1;
        if (outwards > 0) {
            return {true, impacts_};
        }
        double const gap = 1 - side_ * phi;
        double const square = velocity * velocity + 1 - gap * gap;
        return {e_ * std::sqrt(std::max(0.0, square)) > 1, impacts_ + 1};
    }

    double n_, w_, e_, end_, t_ = 0, phi_ = 0, velocity_ = 0;
    double side_ = -1;  // away from a positive acceleration
    int impacts_ = 0;
};

// Between `stands` and `falls`, over g alpha.
double boundary(double stands, double falls, double w, double e) {
    for (int i = 0; i < 60; ++i) {
        double const middle = 0.5 * (stands + falls);
        (LinearBlock(middle, w, e).run().fell ? falls : stands) = middle;
    }
    return 0.5 * (stands + falls);
}

struct Frequency {
    char const* name;
    double w, e;
};

class ZhangMakris : public ::testing::TestWithParam<Frequency> {};

TEST_P(ZhangMakris, BothEdgesOfTheNotchAndTheLeastAmplitude) {
    auto const& [name, w, e] = GetParam();

    auto const found = under_sine(2, w, Restoring::linear, e);

    EXPECT_TRUE(near(found.uplift, 1, testing::rounding));
    ASSERT_EQ(found.ranges.size(), 4U);
    auto const& [rests, first, gap, second] =
        std::tie(found.ranges[0], found.ranges[1], found.ranges[2], found.ranges[3]);
    EXPECT_EQ(rests.fate, Fate::stands);
    EXPECT_EQ(first.fate, Fate::after_impact);
    EXPECT_EQ(gap.fate, Fate::stands);
    EXPECT_EQ(second.fate, Fate::without_impact);
    EXPECT_EQ(found.overturning(), first.from);
    EXPECT_TRUE(near(first.from, boundary(1.001, 0.5 * (first.from + first.to), w, e), sampled));
    EXPECT_TRUE(near(gap.from, boundary(0.5 * (gap.from + gap.to), 0.5 * (first.from + first.to), w, e), sampled));
    // Without an impact there is one equation: cos psi - exp(-(2 pi - psi)/w) = w sin psi, n sin psi = 1.
    double const psi =
        root(1e-6, 0.5 * pi, [&](double at) { return std::cos(at) - std::exp(-(2 * pi - at) / w) - w * std::sin(at); });
    EXPECT_TRUE(near(second.from, 1 / std::sin(psi), sampled));
    EXPECT_TRUE(near(second.to, 12, testing::exact_formula));
}

INSTANTIATE_TEST_SUITE_P(OneSine, ZhangMakris,
                         ::testing::Values(Frequency{"w3", 3, 0.9}, Frequency{"w4", 4, 0.9}, Frequency{"w5", 5, 0.9},
                                           Frequency{"w4_e095", 4, 0.95}),
                         [](auto const& info) { return info.param.name; });

TEST(OverturningRanges, OfAHalfSineAreOneRange) {
    for (auto const& [w, ratio] : {std::pair{1.0, 1.32240}, {4.0, 2.79080}, {10.0, 5.78652}}) {
        auto const found = under_sine(1, w, Restoring::linear);

        EXPECT_TRUE(near(found.overturning(), ratio, testing::Tolerance{5e-6, "six digits"})) << w;
        ASSERT_EQ(found.ranges.size(), 2U);
        EXPECT_EQ(found.ranges[1].fate, Fate::without_impact);
        double const psi = std::asin(1 / ratio);
        EXPECT_NEAR(std::cos(psi) + std::exp(-(pi - psi) / w) - w * std::sin(psi), 0, 1e-4) << "Shi et al. (1996)";
    }
}

TEST(OverturningRanges, NonlinearBlockHasItsKnownEdges) {
    auto const found = under_sine(2, 4, Restoring::nonlinear);

    double const unit = std::tan(alpha) / alpha;
    EXPECT_TRUE(near(found.uplift, unit, testing::rounding));
    ASSERT_EQ(found.ranges.size(), 4U);
    testing::Tolerance const six{5e-6, "six digits"};
    EXPECT_TRUE(near(found.ranges[1].from / unit, 1.80572, six));
    EXPECT_TRUE(near(found.ranges[2].from / unit, 4.97310, six));
    EXPECT_TRUE(near(found.ranges[3].from / unit, 5.32302, six));
}

TEST(OverturningRanges, WhereThereIsNoGapOneRangeFollowsTheOther) {
    auto const found = under_sine(2, 1, Restoring::linear, 0.99);

    for (std::size_t i = 1; i < found.ranges.size(); ++i) {
        EXPECT_EQ(found.ranges[i].from, found.ranges[i - 1].to);
        EXPECT_NE(found.ranges[i].fate, found.ranges[i - 1].fate);
    }
    EXPECT_EQ(found.ranges.front().from, found.uplift);
    EXPECT_EQ(found.ranges.front().fate, Fate::stands);
}

// A boundary that is reported stands, and just beyond it the block falls.
TEST(OverturningRanges, BoundariesAreOnTheSideThatStands) {
    std::vector<double> wave(1200);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        double const t = 0.01 * static_cast<double>(i);
        wave[i] = std::sin(pi * t / 12) * (std::sin(3.1 * t) + 0.7 * std::sin(7.3 * t + 1) + 0.4 * std::sin(13 * t));
    }
    RockingBlock const block{.alpha_rad = alpha, .p_radps = p, .restitution = 0.85};
    Excitation shaking{.horizontal_mps2 = wave, .time_step_s = 0.01};
    auto const found = overturning_ranges(block, shaking);
    auto const falls = [&](double factor) {
        shaking.scale = factor;
        return simulate_rocking(block, shaking).verdict == Verdict::overturned;
    };

    int edges = 0;
    for (std::size_t i = 1; i < found.ranges.size(); ++i) {
        auto const& before = found.ranges[i - 1];
        auto const& range = found.ranges[i];
        if ((before.fate == Fate::stands) != (range.fate == Fate::stands)) {
            bool const rises = before.fate == Fate::stands;
            EXPECT_FALSE(falls(range.from)) << i;
            EXPECT_TRUE(falls(range.from * (rises ? 1 + 2e-10 : 1 - 2e-10))) << i;
            ++edges;
        }
    }
    EXPECT_GE(edges, 3) << "a gap of survival at least";
}

TEST(OverturningRanges, WhatUpliftsCountsTheVerticalMotion) {
    std::vector<double> const horizontal{0, 1, -2, 0};
    std::vector<double> const vertical{0, 3, -1, 0};
    RockingBlock const block{.alpha_rad = alpha, .p_radps = p, .restitution = 0.9};
    Excitation const both{.horizontal_mps2 = horizontal, .vertical_mps2 = vertical, .time_step_s = 0.01};

    double const slope = std::tan(alpha);
    double const factor = uplift_factor(block, both, Restoring::nonlinear);
    EXPECT_TRUE(near(factor, slope * g0 / (2 + slope), testing::rounding));
    auto shaking = both;
    shaking.scale = factor * (1 + 1e-12);
    EXPECT_NE(simulate_rocking(block, shaking).verdict, Verdict::at_rest);
    shaking.scale = factor * (1 - 1e-12);
    EXPECT_EQ(simulate_rocking(block, shaking).verdict, Verdict::at_rest);
}

TEST(OverturningRanges, NothingUpliftsUnderAStillGround) {
    std::vector<double> const still(10, 0.0);
    RockingBlock const block{.alpha_rad = alpha, .p_radps = p, .restitution = 0.9};

    auto const found = overturning_ranges(block, {.horizontal_mps2 = still, .time_step_s = 0.01});

    EXPECT_EQ(found.uplift, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found.overturning(), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(found.ranges.empty());
}

}  // namespace
}  // namespace overturn
