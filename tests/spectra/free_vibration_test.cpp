// Requirement R-201: what oscillators do behind a wave's last sample is part of their spectrum, in closed form: zeros
// that are appended to a wave change nothing.
#include "spectra/detail/free_vibration.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/oscillator_history.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

// The recursion over still ground, finely: what the closed form is held to.
FreePeaks watched(double w, double damping, double y, double v) {
    constexpr double step_s = 1e-4;
    OscillatorStep const step(w, damping, step_s);
    FreePeaks most;
    for (int i = 0; i < 200000; ++i) {
        most.displacement_m = std::max(most.displacement_m, std::abs(y));
        most.velocity_mps = std::max(most.velocity_mps, std::abs(v));
        most.acceleration_mps2 = std::max(most.acceleration_mps2, std::abs(2 * damping * w * v + w * w * y));
        double const next = step.yy * y + step.yv * v;
        v = step.vy * y + step.vv * v;
        y = next;
    }
    return most;
}

TEST(FreeVibration, PeaksAreThoseOfTheMotion) {
    for (double const damping : {0.0, 0.05, 0.5, 0.999999, 1.0, 1.5, 4.0}) {
        for (auto const& [y, v] :
             {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 3.0}, {1.0, -3.0}, {1.0, -30.0}, {-0.3, 1.0}}) {
            double const w = 2 * pi / 1.7;
            auto const expected = watched(w, damping, y, v);
            auto const found = free_peaks(w, damping, y, v);
            EXPECT_NEAR(found.displacement_m, expected.displacement_m, 1e-6) << damping << ", " << y << ", " << v;
            EXPECT_NEAR(found.velocity_mps, expected.velocity_mps, 1e-5) << damping << ", " << y << ", " << v;
            EXPECT_NEAR(found.acceleration_mps2, expected.acceleration_mps2, 2e-4) << damping << ", " << y << ", " << v;
        }
    }
    EXPECT_EQ(free_peak(0, 0.05, 2, 3), 2);
}

// Undamped: the amplitude of y cos + v / w sin.
TEST(FreeVibration, UndampedAmplitude) {
    double const w = 3;
    EXPECT_NEAR(free_peak(w, 0, 2, -5), std::hypot(2, 5 / w), 1e-14);
}

TEST(FreeVibration, ZerosBehindAWaveChangeNothing) {
    for (auto wave :
         {testing::broad_wave(701, 0.01), std::vector<double>{0, 1, 3, -2}, std::vector<double>{0, 0, 5, 0}}) {
        auto const periods = log_periods(0.02, 20, 100);
        auto const plain = response_spectrum(wave, 0.01, periods, 0.05);
        for (std::size_t const zeros : {1U, 7U, 600U}) {
            wave.resize(wave.size() + zeros);
            auto const quiet = response_spectrum(wave, 0.01, periods, 0.05);
            EXPECT_EQ(quiet.sd_m, plain.sd_m) << zeros;
            EXPECT_EQ(quiet.sv_mps, plain.sv_mps) << zeros;
            EXPECT_EQ(quiet.sa_mps2, plain.sa_mps2) << zeros;
        }
    }
}

// One sine of 1 s and 3 m/s2 that ends with its file: an independent recursion over quiet behind it gives 5.194 m/s2.
TEST(FreeVibration, OneSineThatEndsWithItsFile) {
    std::vector<double> sine;
    for (int i = 0; i <= 100; ++i) {
        sine.push_back(3 * std::sin(2 * pi * 0.01 * i));
    }
    std::vector<double> const period{1.533};
    EXPECT_NEAR(response_spectrum(sine, 0.01, period, 0.05).psa_mps2[0], 5.194, 2e-3);
    auto quiet = sine;
    quiet.resize(1000);
    auto const history = testing::oscillator_history(quiet, 0.01, period[0], 0.05);
    double most = 0;
    for (double const y : history.displacement_m) {
        most = std::max(most, std::abs(y));
    }
    double const w = 2 * pi / period[0];
    EXPECT_NEAR(response_spectrum(sine, 0.01, period, 0.05).psa_mps2[0], w * w * most, 1e-4 * w * w * most);
    EXPECT_NEAR(response_spectrum(sine, 0.01, period, 0.05, {.after_end = AfterEnd::left_out}).psa_mps2[0], 3.212,
                2e-3);
}

}  // namespace
}  // namespace overturn
