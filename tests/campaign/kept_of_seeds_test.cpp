// Requirement R-108: what a match takes of a seed's PGV and of its Sa over a body's periods is reported from 5 % on.
#include "campaign/detail/kept_of_seeds.hpp"

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "spectra/response_spectrum.hpp"
#include "support/campaigns.hpp"

namespace overturn {
namespace {

constexpr double dt = 0.01;
constexpr std::array bands{PeriodBand{0.5, 5}, PeriodBand{5, 18}};

// Fast and slow shaking, each a burst that begins and ends gently.
GroundMotion motion(double fast, double slow) {
    GroundMotion made;
    made.time_step_s = dt;
    for (int i = 0; i <= 9000; ++i) {
        double const t = dt * i;
        double const burst = std::pow(std::sin(pi * t / 90), 2);
        made.horizontal_mps2.push_back(burst * (fast * std::sin(2 * pi * t / 0.4) + slow * std::sin(2 * pi * t / 12)));
    }
    return made;
}

/// As if its target were the spectrum of `wanted` times the factor, matched up to 8 s.
GeneratedWave matched(GroundMotion made, GroundMotion const& wanted, double factor) {
    GeneratedWave wave;
    wave.judged_periods_s = log_periods(0.05, 8, 300);
    auto const has = displacement_spectrum(made.horizontal_mps2, dt, wave.judged_periods_s, 0.05);
    auto const wants = displacement_spectrum(wanted.horizontal_mps2, dt, wave.judged_periods_s, 0.05);
    for (std::size_t i = 0; i < has.size(); ++i) {
        wave.ratios.push_back(has[i] / (factor * wants[i]));
    }
    wave.motion = std::move(made);
    return wave;
}

// a seed that is only scaled, as its target asks, keeps all.
TEST(KeptOfSeeds, AFactorLosesNothing) {
    auto const seed = motion(2, 0.5);
    auto const kept = kept_of_seed(seed, matched(motion(6, 1.5), seed, 3), bands);
    constexpr double between_periods = 1e-3;
    EXPECT_NEAR(kept.pgv, 1, between_periods);
    EXPECT_NEAR(kept.sa, 1, between_periods);
}

// without its slow shaking, of which PGV is 1.03 m/s at 12 s beside 0.13 m/s of the fast.
TEST(KeptOfSeeds, SlowShakingThatIsLostIsFound) {
    auto const seed = motion(2, 0.5);
    auto const kept = kept_of_seed(seed, matched(motion(2, 0.05), seed, 1), bands);
    EXPECT_LT(kept.pgv, 0.3);
    EXPECT_LT(kept.sa, 0.4);
    EXPECT_EQ(kept.band.t0_s, 5);
}

// a seed whose PGV is that of 12 s, matched to its own spectrum up to 2 s only, or up to 10 s.
TEST(KeptOfSeeds, PlansReportTheLoss) {
    auto const seed = motion(2, 0.5);
    std::string rows;
    for (std::size_t i = 0; i < seed.samples(); ++i) {
        rows += fmt::format("{:.2f},{:.9g}\n", dt * static_cast<double>(i), seed.horizontal_mps2[i]);
    }
    auto const periods = log_periods(0.05, 10, 60);
    auto const spectrum = response_spectrum(seed.horizontal_mps2, dt, periods, 0.05);
    std::string points;
    for (std::size_t i = 0; i < periods.size(); ++i) {
        points += fmt::format("[{:.17g},{:.17g}],", periods[i], spectrum.psa_mps2[i]);
    }
    auto const line = [&](std::string const& longest) {
        return warning_of_lost_periods(testing::campaign_from(
            "[waves]\nsource='spectrum-compatible'\ncount=1\n[waves.target]\nkind='acceleration'\nlongest=" + longest
                + "\npoints=[" + points + "]\n[waves.seed]\nfiles=['a.csv']\nunit='m/s2'\n" + testing::type_b
                + "[levels]\nmeasure='factor'\nvalues=[1]\n",
            {{"a.csv", rows}}));
    };
    EXPECT_NE(line("2").find("1 of the first 1 seeds lose more than 5 % of PGV"), std::string::npos) << line("2");
    EXPECT_EQ(line("10"), "");
    EXPECT_EQ(warning_of_lost_periods(
                  testing::campaign_from(testing::quick_waves + testing::type_b + testing::levels("values=[1]\n"))),
              "");
}

}  // namespace
}  // namespace overturn
