// Requirement: the figures of a match are those of their definitions.
#include "generators/match_figures.hpp"

#include <cmath>
#include <vector>

#include "spectra/response_spectrum.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

TEST(MatchFigures, ByHand) {
    std::vector<double> const periods{1, 2, 3, 4, 5, 6};
    std::vector<double> const ratios{0.9, 0.8, 1.2, 0.95, 0.9, 0.97};

    auto const figures = match_figures(periods, ratios, 0, 6);

    EXPECT_EQ(figures.lowest_ratio, 0.8);
    EXPECT_EQ(figures.highest_ratio, 1.2);
    EXPECT_EQ(figures.longest_below, 3);
    EXPECT_NEAR(figures.mean_misfit, 0.68 / 6, 1e-15);
    EXPECT_EQ(match_figures(periods, ratios, 2.5, 3.5).longest_below, 0);
    EXPECT_EQ(match_figures(periods, ratios, 0, 2.5).longest_below, 2);
}

// A misfit of 0.1 over one decade of three: no window of a decade holds more, and one holds it all.
TEST(WorstDecade, FindsTheDecadeThatIsWrong) {
    auto const periods = log_periods_per_decade(0.01, 10, 100);
    std::vector<double> ratios(periods.size(), 1.0);
    for (std::size_t i = 100; i <= 200; ++i) {
        ratios[i] = i % 2 == 0 ? 1.1 : 0.9;
    }
    EXPECT_TRUE(testing::near(worst_decade_misfit(periods, ratios), 0.1, testing::exact_formula));
    for (std::size_t i = 150; i <= 200; ++i) {
        ratios[i] = 1;
    }
    EXPECT_TRUE(testing::near(worst_decade_misfit(periods, ratios), 0.1 * 50 / 101, testing::exact_formula));
    std::vector<double> const few{1, 2, 3};
    EXPECT_TRUE(testing::near(worst_decade_misfit(few, std::vector{1.1, 1.2, 0.7}), 0.2, testing::exact_formula));
}

// psv of a constant acceleration target grows with T; a ratio that is 1 + T there gives int (1+T) T dT over int T dT.
TEST(SpectralIntensity, IsTheRatioOfIntegrals) {
    std::vector<std::pair<double, double>> const flat{{0.01, 2.0}, {20.0, 2.0}};
    auto const target = TargetSpectrum::from_points("flat", 0.05, TargetKind::acceleration, flat);
    auto const periods = log_periods_per_decade(0.02, 10, 400);
    std::vector<double> ratios;
    for (double const period : periods) {
        ratios.push_back(1 + period);
    }
    auto const power = [](double n) { return std::pow(2.5, n) - std::pow(0.1, n); };
    double const exact = 1 + (power(3) / 3) / (power(2) / 2);

    EXPECT_NEAR(spectral_intensity_ratio(periods, ratios, target), exact, 1e-4);
    EXPECT_EQ(spectral_intensity_ratio(std::vector{0.2, 3.0}, std::vector{1.0, 1.0}, target), 0);
}

}  // namespace
}  // namespace overturn
