// Requirement R-102: a step on the lines moves the peaks of responses where it was asked to.
#include "generators/detail/line_gains.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "generators/detail/real_fft.hpp"
#include "spectra/oscillator.hpp"
#include "spectra/peak_response.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/oscillator_history.hpp"
#include "support/waves.hpp"

namespace overturn {
namespace {

// Peaks may move to other instants; at the old ones the responses must come to where the step was asked to take them.
TEST(LineGains, ResponsesAtThePeaksMoveAsAsked) {
    RealFft const fft(20000);
    double const spacing = 2 * pi / 200;
    std::vector<std::complex<double>> lines(10000);
    for (std::size_t k = 20; k < lines.size(); ++k) {
        auto const turn = static_cast<double>(k * k);
        lines[k] = std::polar(1 / static_cast<double>(k), 2 * pi * std::fmod(0.6180339887498949 * turn, 1.0));
    }
    auto const wave_of = [&] {
        std::vector<double> series(fft.length());
        fft.synthesise(lines, series);
        return series;
    };
    auto const periods = log_periods_per_decade(0.1, 5, 100);
    PeakResponse const sweep(periods, 0.05, 0.01);
    LineGains const gains(periods, 0.05, spacing, 20, 10000);
    auto const before = sweep.peaks(wave_of());
    std::vector<double> wanted;
    for (double const period : periods) {
        wanted.push_back(1 + 0.1 * std::sin(6 * std::log(period)));
    }
    auto const phases = lines;

    gains.apply(lines, before, std::vector<double>(periods.size(), 1.0), wanted, LineGains::Trust::little);

    auto const after = wave_of();
    double left = 0, asked = 0;
    for (std::size_t i = 0; i < periods.size(); ++i) {
        auto const at = static_cast<std::size_t>(std::lround(before[i].time_s / 0.01));
        double const now = testing::oscillator_history(after, 0.01, periods[i], 0.05).displacement_m.at(at);
        double const missed = now / before[i].displacement_m - wanted[i];
        left += missed * missed;
        asked += (wanted[i] - 1) * (wanted[i] - 1);
    }
    EXPECT_LT(left, 0.04 * asked);  // a fifth of the wish, root mean square
    for (std::size_t k = 20; k < lines.size(); ++k) {
        EXPECT_NEAR(std::arg(lines[k] / phases[k]), 0, 1e-12);  // amplitudes only
    }
}

}  // namespace
}  // namespace overturn
