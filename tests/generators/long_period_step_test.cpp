// Requirement: a step on slow lines, amplitudes and phases, moves slow responses where it was asked to.
#include "generators/detail/long_period_step.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "spectra/response_spectrum.hpp"
#include "support/oscillator_history.hpp"

namespace overturn {
namespace {

// Oscillators of up to 8 s under a wave of 30 s, whose memory is as long as the wave: at the instants of their peaks
// the responses come to where the step was asked to take them. With the sign of the phases' part turned round, or with
// the stationary sums of LineGains, they do not.
TEST(LongPeriodStep, ResponsesAtThePeaksMoveAsAsked) {
    constexpr double dt = 0.01;
    Envelope const envelope{.shape = EnvelopeShape::jennings, .rise_s = 4, .level_end_s = 16, .end_s = 28};
    std::vector<std::pair<double, double>> const points{{0.02, 3}, {1, 3}, {10, 0.3}};
    auto const target = TargetSpectrum::from_points("flat", 0.05, TargetKind::acceleration, points);
    NoiseLines const noise(
        {.target = target, .longest_s = 10, .time_step_s = dt, .samples = 3001, .envelope = envelope});
    std::vector<double> const periods = log_periods_per_decade(LongPeriodStep::from_s, 8, 50);
    PeakResponse const sweep(periods, 0.05, dt);
    LongPeriodStep const step(periods, 0.05, noise);
    double left = 0, asked = 0;
    for (std::uint64_t wave = 0; wave < 8; ++wave) {
        auto lines = noise.draw(LineStreams::of_wave(11, wave, 0));
        auto const before = sweep.peaks(noise.synthesise(lines, noise.envelope()));
        std::vector<double> wanted;
        for (double const period : periods) {
            wanted.push_back(1 + 0.1 * std::sin(3 * std::log(period) + static_cast<double>(wave)));
        }
        step.apply(lines, before, wanted, noise.envelope(), noise);
        auto const after = noise.synthesise(lines, noise.envelope());
        for (std::size_t i = 0; i < periods.size(); ++i) {
            auto const at = static_cast<std::size_t>(std::lround(before[i].time_s / dt));
            double const now = testing::oscillator_history(after, dt, periods[i], 0.05).displacement_m.at(at);
            double const missed = now / before[i].displacement_m - wanted[i];
            left += missed * missed;
            asked += (wanted[i] - 1) * (wanted[i] - 1);
        }
    }
    EXPECT_LT(left, 0.1 * asked);
}

}  // namespace
}  // namespace overturn
