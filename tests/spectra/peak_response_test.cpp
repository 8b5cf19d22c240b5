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

// A rattle in the first tile, which stiff oscillators feel, and at the end a slow push, which the others do.
TEST(PeakResponse, SeesPeaksOfATileCutShort) {
    for (std::size_t samples = 36; samples < 64; ++samples) {
        std::vector<double> wave(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            wave[i] = i < 24 ? (i % 2 == 0 ? 8.0 : -8.0) : i > 32 ? 1.0 : 0.0;
        }
        wave[samples - 2] = -4;  // and back
        wave[samples - 1] = -4;
        for (double const damping : {0.05, 0.9, 2.0}) {
            expect_exact(wave, 0.01, damping, 2);
        }
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

// `parts` steps to a sample of the wave.
std::vector<double> cut(std::vector<double> const& wave, int parts) {
    std::vector<double> fine;
    for (std::size_t n = 0; n + 1 < wave.size(); ++n) {
        for (int s = 0; s < parts; ++s) {
            fine.push_back(wave[n] + (wave[n + 1] - wave[n]) * s / parts);
        }
    }
    fine.push_back(wave.back());
    return fine;
}

// Also where the peak lies between two samples, and where the wave ends before a tile does.
TEST(PeakResponse, KnowsSignAndInstant) {
    for (std::size_t const samples : {12001U, 4001U, 45U}) {
        auto const wave = samples > 100 ? testing::broad_wave(samples, 0.01) : sweeping_wave(samples);
        for (double const damping : {0.05, 0.4, 0.97}) {
            auto const periods = log_periods_per_decade(0.02, 10, 30);
            auto const peaks = PeakResponse(periods, damping, 0.01).peaks(wave);
            int within = 0;
            for (std::size_t i = 0; i < periods.size(); ++i) {
                int const parts = steps_per_sample(periods[i], 0.01, {});
                double const step_s = 0.01 / parts;
                auto const history =
                    testing::oscillator_history(cut(wave, parts), step_s, periods[i], damping).displacement_m;
                auto const at = static_cast<std::size_t>(std::lround(peaks[i].time_s / step_s));
                if (at < history.size()) {  // else free vibration, which other tests know
                    EXPECT_NEAR(history[at] / peaks[i].displacement_m, 1, 1e-9) << periods[i] << ' ' << damping;
                    EXPECT_NEAR(static_cast<double>(at) * step_s, peaks[i].time_s, 1e-9);
                    ++within;
                }
            }
            EXPECT_GT(within, samples > 100 ? 80 : 20) << damping;
        }
    }
}

// Critically damped oscillators that a steady ground bends come to rest bent, and stay so to the last bit: the peak is
// where they first are, however long they stay.
TEST(PeakResponse, TakesTheFirstOfEqualPeaks) {
    PeakResponse const response({0.02, 0.03, 0.3, 0.5, 2}, 1, 0.01);
    auto const after = [&](std::size_t samples) { return response.peaks(std::vector<double>(samples, 1.0)); };
    auto const once = after(3000);
    auto const longer = after(6000);
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(longer[i].displacement_m, once[i].displacement_m) << i;
        EXPECT_EQ(longer[i].time_s, once[i].time_s) << i;
        EXPECT_LT(once[i].time_s, 29) << i;
    }
}

TEST(PeakResponse, ScalesWithTheWave) {
    auto const wave = sweeping_wave(3000);
    PeakResponse const response(log_periods_per_decade(0.02, 10, 30), 0.05, 0.01);
    auto const peaks = response.peaks(wave);
    for (double const factor : {0x1p-50, 0x1p50}) {  // exact
        auto scaled = wave;
        for (double& a : scaled) {
            a *= factor;
        }
        auto const found = response.peaks(scaled);
        for (std::size_t i = 0; i < peaks.size(); ++i) {
            EXPECT_EQ(found[i].displacement_m, factor * peaks[i].displacement_m) << factor << ' ' << i;
            EXPECT_EQ(found[i].time_s, peaks[i].time_s) << factor << ' ' << i;
        }
    }
}

// Groups are read one after another into the same place; nothing of one shows in the next.
TEST(PeakResponse, ForgetsTheGroupBefore) {
    std::vector<std::vector<double>> waves{sweeping_wave(33), sweeping_wave(34), sweeping_wave(70)};
    for (double const a : {0.3, 0.7, 1.1, 3.0}) {
        waves.push_back({a, 0});
    }
    for (auto const& wave : waves) {
        for (double const damping : {0.05, 0.3, 0.9}) {
            for (double const period : {0.2, 0.6, 3.0}) {
                auto const alone = PeakResponse({period}, damping, 0.01).peaks(wave).back();
                auto const last = PeakResponse({0.021, 0.033, period}, damping, 0.01).peaks(wave).back();
                EXPECT_EQ(last.displacement_m, alone.displacement_m) << wave.size() << ' ' << period;
                EXPECT_EQ(last.time_s, alone.time_s) << wave.size() << ' ' << period;
            }
        }
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
