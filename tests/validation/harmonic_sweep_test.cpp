// Requirement R-404: the published steady state (the paper's Eq. 1, Spanos & Koh 1984) comes out of a whole campaign: a
// slender body under slowly growing sinusoids, the nonlinear equation, impacts and all, started at rest.
#include <cmath>

#include "campaign/trial.hpp"
#include "rocking/closed_forms.hpp"
#include "support/campaigns.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

constexpr double half_width_m = 0.1;
constexpr double centre_height_m = 1;

constexpr double duration_s = 300;
constexpr double ramp_s = 100;

// The largest rotation after the growth and its transients, before the decay.
class SteadyPeak : public Observer {
  public:
    void begin(std::span<Channel const> channels) override {
        ASSERT_EQ(channels[0].key, "time_s");
        ASSERT_EQ(channels[1].key, "rotation_rad");
    }
    void at(std::span<double const> values) override {
        if (values[0] > duration_s - 1.5 * ramp_s && values[0] < duration_s - ramp_s) {
            peak_rad = std::max(peak_rad, std::abs(values[1]));
        }
    }
    double peak_rad = 0;
};

// The steady rotation over alpha of one body at one sigma = omega / p and k = A / (g alpha).
double steady_ratio(HarmonicCase const& c) {
    double const radius = std::hypot(half_width_m, centre_height_m);
    double const p = std::sqrt(0.75 * g0 / radius);
    double const alpha = std::atan(half_width_m / centre_height_m);
    double const frequency = c.frequency_ratio * p / (2 * pi);
    auto const spec = testing::campaign_from(
        fmt::format("[waves]\nsource='harmonic'\namplitude=1\nfrequency={}\nduration={}\nramp={}\ntime_step={}\n"
                    "[[bodies]]\nmass=1\nbase_width={}\ncentre_height={}\ninertia='uniform-block'\nrestitution={}\n"
                    "[levels]\nmeasure='pga'\nvalues=[{}]\n[measures]\nrocked_from=0\n",
                    frequency, duration_s, ramp_s, 1 / frequency / 64, 2 * half_width_m, centre_height_m, c.restitution,
                    c.amplitude_ratio * g0 * alpha));
    PhaseSeconds seconds;
    SteadyPeak seen;
    auto const row = run_trial(spec, prepare_wave(spec, Plan(spec), 0, seconds), 0, 0, &seen).rows.front();
    EXPECT_EQ(row.verdict, Verdict::rocked);
    EXPECT_GE(row.peak_rotation_rad, seen.peak_rad);
    return seen.peak_rad / alpha;
}

struct Published {
    char const* name;
    HarmonicCase c;
};

class HarmonicSweep : public ::testing::TestWithParam<Published> {};

TEST_P(HarmonicSweep, PeakRotationIsTheSteadyOne) {
    double const steady = steady_harmonic_rotation(GetParam().c);
    EXPECT_TRUE(testing::near(steady_ratio(GetParam().c), steady, testing::Tolerance{0.006, "nonlinear"}));
}

INSTANTIATE_TEST_SUITE_P(Cases, HarmonicSweep,
                         ::testing::Values(Published{"sigma3", {3, 1.5, 0.9}}, Published{"sigma4", {4, 2, 0.9}},
                                           Published{"sigma5", {5, 2, 0.9}}, Published{"sigma8", {8, 4, 0.8}},
                                           Published{"sigma12", {12, 6, 0.8}}),
                         [](auto const& info) { return info.param.name; });

}  // namespace
}  // namespace overturn
