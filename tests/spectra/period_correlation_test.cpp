// Requirement R-103: deviations of spectra are correlated between periods as published, or as a file states.
#include "spectra/period_correlation.hpp"

#include <cmath>

#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "core/units.hpp"
#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

// Values worked out by hand from the five branches of the printed equation.
TEST(BakerJayaram, HasTheValuesOfThePrintedEquation) {
    struct Printed {
        double a, b, rho;
    };
    for (auto const& [a, b, rho] :
         {Printed{1, 2, 0.749021}, Printed{3, 4, 0.894903}, Printed{1, 3, 0.608656}, Printed{0.2, 2, 0.253527},
          Printed{0.05, 0.1, 0.942121}, Printed{0.1, 0.15, 0.884352}, Printed{0.05, 0.3, 0.728668}}) {
        EXPECT_NEAR(baker_jayaram_2008(a, b), rho, 1e-6) << a << " s and " << b << " s";
        EXPECT_EQ(baker_jayaram_2008(a, b), baker_jayaram_2008(b, a));
    }
    // At 0.2 s itself the branch from there on holds, whose C2 is nothing: C4 = C1 + (sqrt(C1) - C1) (1 + cos) / 2.
    double const c1 = 1 - std::cos(pi / 2 - 0.366 * std::log(0.2 / 0.109));
    EXPECT_NEAR(baker_jayaram_2008(0.05, 0.2), c1 + 0.5 * (std::sqrt(c1) - c1) * (1 + std::cos(pi * 0.05 / 0.109)),
                1e-12);
    EXPECT_EQ(baker_jayaram_2008(0.7, 0.7), 1);
    EXPECT_EQ(baker_jayaram_2008(10, 17), 1) << "beyond 10 s its last value holds";
}

// The branches meet to within the rounding of the printed coefficients.
TEST(BakerJayaram, IsContinuousAcrossItsBranches) {
    for (double const other : {0.02, 0.08, 0.15, 0.5, 4.0}) {
        for (double period = 0.0101; period < 9.9; period *= 1.001) {
            EXPECT_NEAR(baker_jayaram_2008(period, other), baker_jayaram_2008(period * 1.001, other), 1e-3)
                << period << " s and " << other << " s";
        }
    }
}

// A table of six periods against the closed form it was made from; straight lines in between stay within its bend.
std::string table_of(std::vector<double> const& periods) {
    std::string text = "# T [s]\n";
    for (double const period : periods) {
        text += fmt::format(" {}", period);
    }
    for (double const row : periods) {
        text += fmt::format("\n{}", row);
        for (double const column : periods) {
            text += fmt::format(", {:.8f}", baker_jayaram_2008(row, column));
        }
    }
    return text + "\n";
}

TEST(TabulatedCorrelation, IsTheTableAtItsPeriodsAndStraightBetween) {
    auto const table = TabulatedCorrelation::parse(table_of({0.2, 0.5, 1, 2, 4, 8}), "rho.txt");
    EXPECT_NEAR(table(1, 4), baker_jayaram_2008(1, 4), 1e-8);
    double const middle = std::sqrt(2.0);  // in log, of 1 s and 2 s
    EXPECT_NEAR(table(middle, 8), (baker_jayaram_2008(1, 8) + baker_jayaram_2008(2, 8)) / 2, 1e-8);
    EXPECT_NEAR(table(0.5, middle), table(middle, 0.5), 1e-15);
    EXPECT_EQ(table(0.01, 1), table(0.2, 1));
    EXPECT_EQ(table(middle, middle), 1);
}

TEST(TabulatedCorrelation, WhatIsNoneIsRefusedAtItsLine) {
    auto const parse = [](char const* text) { (void)TabulatedCorrelation::parse(text, "rho.txt"); };
    expect_input_error([&] { parse("1 2\n1 1 .5\n2 .4 1\n"); }, "rho.txt:2");
    expect_input_error([&] { parse("1 2\n1 1 .5\n2 .4 1\n"); }, "the other way round");
    expect_input_error([&] { parse("1 2\n1 1 .5\n"); }, "1 of 2 lines");
    expect_input_error([&] { parse("1 2\n1 1 .5 .3\n2 .5 1\n"); }, "4 numbers");
    expect_input_error([&] { parse("2 1\n2 1 .5\n1 .5 1\n"); }, "periods are positive and rise");
    expect_input_error([&] { parse("1 2\n1 .9 .5\n2 .5 1\n"); }, "diagonal");
    expect_input_error([&] { parse("1 2\n1 1 1.5\n2 1.5 1\n"); }, "within -1 and 1");
    expect_input_error([&] { parse("1 2\n1 1 x\n2 .5 1\n"); }, "'x'");
    expect_input_error([&] { parse("1 2\n1 1 .5\n3 .5 1\n"); }, "follow the periods");
}

// Sums over 20 000 draws: each correlation within four of its standard errors, each variance 1.
TEST(CorrelatedNormals, DrawsHaveTheStatedCorrelations) {
    std::vector<double> const periods{0.02, 0.1, 0.3, 1, 2, 3, 4, 10};
    CorrelatedNormals const correlated(periods, baker_jayaram_2008);
    constexpr int draws = 20000;
    std::vector<std::vector<double>> sums(periods.size(), std::vector<double>(periods.size()));
    for (int draw = 0; draw < draws; ++draw) {
        RandomStream stream(7, static_cast<std::uint64_t>(draw), Purpose::target_spectrum);
        std::vector<double> normals(periods.size());
        for (double& normal : normals) {
            normal = gsl_ran_gaussian_ziggurat(stream.gsl(), 1);
        }
        auto const deviations = correlated(normals);
        for (std::size_t i = 0; i < periods.size(); ++i) {
            for (std::size_t j = 0; j < periods.size(); ++j) {
                sums[i][j] += deviations[i] * deviations[j] / draws;
            }
        }
    }
    for (std::size_t i = 0; i < periods.size(); ++i) {
        for (std::size_t j = 0; j < periods.size(); ++j) {
            double const rho = baker_jayaram_2008(periods[i], periods[j]);
            EXPECT_NEAR(sums[i][j], rho, 4 * std::sqrt((1 + rho * rho) / draws)) << periods[i] << ", " << periods[j];
        }
    }
}

TEST(CorrelatedNormals, CorrelationsThatContradictEachOtherAreRefused) {
    auto const odd = [](double a, double b) { return a == b ? 1.0 : a * b == 2 || a * b == 6 ? 0.9 : -0.9; };
    expect_input_error([&] { CorrelatedNormals({1, 2, 3}, odd); }, "no spectra can have");
}

}  // namespace
}  // namespace overturn
