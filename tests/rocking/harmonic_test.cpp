// Requirement R-404: the paper's Eq. 1 (Spanos & Koh 1984) is computed as corrected, and the time history reaches it.
#include <cmath>
#include <vector>

#include "rocking/closed_forms.hpp"
#include "rocking/planar_rocking.hpp"
#include "support/expect_input_error.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::near;

struct Known {
    char const* name;
    HarmonicCase c;
    double mid_ratio, max_ratio;
};

class SteadyHarmonic : public ::testing::TestWithParam<Known> {};

TEST_P(SteadyHarmonic, FormulaGivesTheCheckedValue) {
    EXPECT_TRUE(near(steady_harmonic_rotation(GetParam().c), GetParam().mid_ratio, testing::printed_digits));
}

class PeakSeen : public RockingObserver {
  public:
    explicit PeakSeen(double until_s) : until_s_(until_s) {}
    void at(RockingInstant const& instant) override {
        if (instant.time_s > until_s_) {
            return;  // free rocking after the wave
        }
        peak = std::max(peak, std::abs(instant.rotation_rad));
        impacts += instant.rotation_rad == 0 ? 1 : 0;
    }
    double peak = 0;
    int impacts = 0;

  private:
    double until_s_;
};

// Started on the steady orbit in the middle of a half cycle (several steady states exist, so a slow start may find
// another), the block stays on it, and its largest rotation is the known one.
TEST_P(SteadyHarmonic, TimeHistoryStaysOnTheOrbit) {
    auto const& [name, c, mid, largest] = GetParam();
    RockingBlock const block{.alpha_rad = 0.2, .p_radps = 2.0, .restitution = c.restitution};
    double const U = pi / (2 * c.frequency_ratio);
    double const C = c.amplitude_ratio / (1 + c.frequency_ratio * c.frequency_ratio);
    double const phase_sine = (mid - 1 + 1 / std::cosh(U)) / C;
    double const r = (1 - c.restitution) / (1 + c.restitution);
    double const phase_cosine = r * c.frequency_ratio * std::tanh(U) * phase_sine + r * std::tanh(U) * std::tanh(U) / C;
    double const rate = c.frequency_ratio * C * phase_cosine - C * phase_cosine / std::sinh(U);
    constexpr int per_cycle = 4000;
    constexpr int cycles = 10;
    double const dt = 2 * pi / (c.frequency_ratio * block.p_radps) / per_cycle;
    std::vector<double> a(per_cycle * cycles);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = c.amplitude_ratio * block.gravity_mps2 * block.alpha_rad
               * std::sin(2 * pi * static_cast<double>(i) / per_cycle + std::atan2(phase_sine, phase_cosine));
    }
    PeakSeen seen(dt * static_cast<double>(a.size() - 1));

    (void)simulate_rocking(
        block, {.horizontal_mps2 = a, .vertical_mps2 = {}, .time_step_s = dt}, {.restoring = Restoring::linear},
        {.rotation_rad = mid * block.alpha_rad, .velocity_radps = rate * block.alpha_rad * block.p_radps}, &seen);

    EXPECT_EQ(seen.impacts, 3 * 2 * cycles);  // before, after, and the next step's start
    EXPECT_TRUE(near(seen.peak / block.alpha_rad, largest, testing::Tolerance{2e-6, "sampled_sine"}));
}

INSTANTIATE_TEST_SUITE_P(Checked, SteadyHarmonic,
                         ::testing::Values(Known{"sigma3", {3, 1.5, 0.9}, 0.27115540, 0.27132594},
                                           Known{"sigma5", {5, 2, 0.9}, 0.12353437, 0.12360780},
                                           Known{"sigma8", {8, 4, 0.8}, 0.07878169, 0.07896934}),
                         [](auto const& info) { return info.param.name; });

TEST(SteadyHarmonicLimits, NoSteadyStateIsReported) {
    testing::expect_input_error([] { (void)steady_harmonic_rotation({8, 0.1, 0.5}); }, "no such steady state");
}

}  // namespace
}  // namespace overturn
