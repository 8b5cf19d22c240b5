// Requirement: input energy is exact; without damping it is the Fourier amplitude.
#include "spectra/input_energy.hpp"

#include <cmath>

#include "core/units.hpp"
#include "motion/ground_motion.hpp"
#include "spectra/detail/fourier.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/fourier_amplitude.hpp"
#include "support/oscillator_history.hpp"
#include "support/tolerance.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

using testing::near;

TEST(InputEnergy, UndampedRecursionEqualsTheFourierAmplitude) {
    auto const wave = testing::broad_wave(16384, 0.01);
    auto const periods = log_periods(1e-3, 600, 80);

    auto const exact = undamped_energy_velocities(wave, 0.01, periods);
    auto const energy = input_energy_velocities(wave, 0.01, periods, 0.0);

    for (std::size_t i = 0; i < periods.size(); ++i) {
        auto const history = testing::oscillator_history(wave, 0.01, periods[i], 0.0);
        double const final_state =
            std::hypot(history.velocity_mps.back(), 2 * pi / periods[i] * history.displacement_m.back());
        double const scale = std::max(exact[i], 1e-3);
        EXPECT_TRUE(near(final_state, exact[i], testing::integrated, scale)) << periods[i];
        EXPECT_TRUE(near(energy[i] * energy[i], exact[i] * exact[i], testing::integrated, scale)) << periods[i];
    }
}

TEST(InputEnergy, IsKineticPlusElasticPlusDamped) {
    auto const wave = testing::broad_wave(4000, 0.005);
    for (double const damping : {0.1, 1.0, 2.5}) {
        double const w = 2 * pi / 0.7;
        auto const history = testing::oscillator_history(wave, 0.005, 0.7, damping);
        double damped = 0;  // Simpson on a spacing much shorter than anything in the response
        auto const& v = history.velocity_mps;
        for (std::size_t n = 2; n < v.size(); n += 2) {
            damped += 0.005 / 3 * (v[n - 2] * v[n - 2] + 4 * v[n - 1] * v[n - 1] + v[n] * v[n]);
        }
        auto const last = v.size() - 2;  // Simpson ends on an even sample
        double const y = history.displacement_m[last];
        double const energy = 0.5 * v[last] * v[last] + 0.5 * w * w * y * y + 2 * damping * w * damped;

        auto const computed =
            input_energy_velocities(std::span(wave).first(last + 1), 0.005, std::vector{0.7}, damping);

        EXPECT_TRUE(near(computed[0], std::sqrt(2 * energy), testing::Tolerance{1e-5, "Simpson"})) << damping;
    }
}

TEST(InputEnergy, FourierAmplitudeOfATriangleIsExact) {
    constexpr double dt = 0.02;
    std::vector<double> const triangle{0, 1.5, 3, 1.5, 0, 0, 0};  // half-width 0.04 s
    for (double const w : {0.0, 1e-7, 1.0, 49.9, 50.1, 300.0}) {
        double const x = 0.5 * w * 2 * dt;
        double const sinc = x == 0 ? 1.0 : std::sin(x) / x;
        EXPECT_TRUE(near(std::abs(testing::fourier_amplitude(triangle, dt, w)), 3 * 2 * dt * sinc * sinc,
                         testing::exact_formula, 0.12))
            << w;
    }
}

TEST(InputEnergy, FourierSumMatchesTheTermByTermIntegral) {
    auto const wave = testing::broad_wave(1001, 0.01);  // not a multiple of the block
    for (double const w : {0.3, 7.0, 90.0}) {
        std::complex<double> sum = 0;
        for (std::size_t n = 1; n < wave.size(); ++n) {
            HatWeights const hat(w * 0.01);
            auto const t0 = 0.01 * static_cast<double>(n - 1);
            sum += 0.01
                   * (wave[n - 1] * hat.right * std::polar(1.0, -w * t0)
                      + wave[n] * std::conj(hat.right) * std::polar(1.0, -w * (t0 + 0.01)));
        }
        EXPECT_LT(std::abs(testing::fourier_amplitude(wave, 0.01, w) - sum), 1e-12 * (1 + std::abs(sum))) << w;
    }
}

TEST(InputEnergy, ZeroFrequencyIsTheFinalVelocity) {
    auto const wave = testing::broad_wave(5000, 0.01);

    EXPECT_TRUE(near(testing::fourier_amplitude(wave, 0.01, 0).real(), velocity_of(wave, 0.01).back(),
                     testing::exact_formula, 1.0));
}

TEST(InputEnergy, EnergyGrowsLinearlyInTimeAtResonance) {
    std::vector<double> wave(20001);
    for (std::size_t n = 0; n < wave.size(); ++n) {
        wave[n] = 2 * std::sin(2 * pi * 0.001 * static_cast<double>(n));
    }
    // V_E0 of A sin(wt) over k whole cycles at its own period is A t / 2.
    auto const at_20s = undamped_energy_velocities(wave, 0.001, std::vector{1.0});
    auto const at_10s = undamped_energy_velocities(std::span(wave).first(10001), 0.001, std::vector{1.0});
    EXPECT_TRUE(near(at_20s[0], 20, testing::Tolerance{1e-5, "sampled sine"}));
    EXPECT_TRUE(near(at_10s[0], 10, testing::Tolerance{1e-5, "sampled sine"}));
}

}  // namespace
}  // namespace overturn
