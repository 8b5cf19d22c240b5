// Requirement R-102: the quick search for peaks finds those of the exact spectrum, in any wave and at any damping up to
// five times the critical one.
#include "spectra/peak_response.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/oscillator_history.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

std::vector<double> magnitudes(std::vector<PeakDisplacement> const& peaks) {
    std::vector<double> values;
    for (auto const& peak : peaks) {
        values.push_back(std::abs(peak.displacement_m));
    }
    return values;
}

// Both sweep exactly; they differ by what rounding does to forms with and without a velocity.
void expect_exact(std::vector<double> const& wave, double time_step_s, double damping, double longest_s = 20) {
    auto const periods = log_periods_per_decade(2 * time_step_s, longest_s, 30);
    auto const found = magnitudes(PeakResponse(periods, damping, time_step_s).peaks(wave));
    auto const exact = displacement_spectrum(wave, time_step_s, periods, damping);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        EXPECT_NEAR(found[i], exact[i], 1e-9 * exact[i]) << periods[i] << " s, damping " << damping;
    }
}

// Sounds of rising pitch, beats and steps: what lies between samples, and where, differs from that of noise.
std::vector<double> sweeping_wave(std::size_t samples) {
    std::vector<double> wave(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        auto const t = static_cast<double>(i);
        double const rising = std::sin(3.1 * t * t / (2 * static_cast<double>(samples)));
        double const beats = std::sin(2.9 * t) * std::sin(0.003 * t);
        wave[i] = rising + beats + (i % 1700 < 3 ? 2.0 : 0.0);
    }
    return wave;
}

TEST(PeakResponse, IsTheExactSpectrum) {
    auto wave = testing::broad_wave(12001, 0.01);
    for (double const damping : {0.0, 0.005, 0.05, 0.3, 0.8}) {
        expect_exact(wave, 0.01, damping);
    }
    wave[0] = 3;  // as records have it
    expect_exact(wave, 0.01, 0.05);
    wave[0] = 0;
    wave.back() = 9;  // peaks at their highest when the wave ends
    expect_exact(wave, 0.01, 0.05);
}

TEST(PeakResponse, SeesWhatSwingsBetweenSamples) {
    auto const wave = sweeping_wave(16384);
    for (double const damping : {0.0, 0.02, 0.05, 0.5}) {
        expect_exact(wave, 0.01, damping);
    }
}

TEST(PeakResponse, HardCases) {
    EXPECT_EQ(magnitudes(PeakResponse({0.02, 0.3, 4}, 0.05, 0.01).peaks({})), std::vector<double>(3, 0.0));
    auto const wave = sweeping_wave(3000);
    expect_exact(wave, 0.01, 1);       // nothing vibrates
    expect_exact(wave, 0.01, 5, 5);    // far beyond
    expect_exact(wave, 0.01, 0.97);    // nearly nothing
    expect_exact(wave, 0.0005, 0.05);  // long periods of 40000 samples
    for (std::size_t const samples : {2U, 3U, 32U, 33U, 34U, 65U}) {
        expect_exact(sweeping_wave(samples), 0.01, 0.05);
    }
    for (auto const& peak : PeakResponse({0.02, 0.3, 4}, 0.05, 0.01).peaks(std::vector<double>(500, 0.0))) {
        EXPECT_EQ(peak.displacement_m, 0);
    }
}

TEST(PeakResponse, KnowsSignAndInstant) {
    auto const wave = testing::broad_wave(12001, 0.01);
    auto const periods = log_periods_per_decade(0.1, 10, 30);
    auto const peaks = PeakResponse(periods, 0.05, 0.01).peaks(wave);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        auto const history = testing::oscillator_history(wave, 0.01, periods[i], 0.05).displacement_m;
        auto const at = static_cast<std::size_t>(std::lround(peaks[i].time_s / 0.01));
        EXPECT_NEAR(history.at(at) / peaks[i].displacement_m, 1, 1e-9) << periods[i];
    }
}

// A half sine far longer than the oscillator's own period: y = -a/w^2, at the pulse.
TEST(PeakResponse, StiffOscillatorFollowsTheGround) {
    std::vector<double> wave(2001, 0.0);
    for (std::size_t i = 0; i < 400; ++i) {
        wave[600 + i] = std::sin(pi * static_cast<double>(i) / 400);
    }
    auto const peak = PeakResponse({0.05}, 0.05, 0.01).peaks(wave).front();
    double const w = 2 * pi / 0.05;

    EXPECT_NEAR(peak.displacement_m * w * w, -1, 1e-3);
    EXPECT_NEAR(peak.time_s, 8, 0.05);
}

}  // namespace
}  // namespace overturn
