// Requirement R-704: of separated data the penalised fit is the maximum of Firth's likelihood.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include "stats/fragility.hpp"
#include "support/stripe_tables.hpp"

namespace overturn {
namespace {

using testing::table_of;

/// The maxima of Firth's likelihood, from an independent maximisation in another language.
TEST(PenalisedFit, OfTouchingData) {
    auto const expect = [](std::optional<ProbitLine> const& fit, double median, double beta) {
        ASSERT_TRUE(fit);
        EXPECT_NEAR(std::exp(fit->log_median()), median, 5e-5 * median);
        EXPECT_NEAR(fit->beta(), beta, 5e-5);
    };
    auto const stripes = [](std::vector<double> const& at, std::vector<std::int64_t> const& overturned) {
        std::vector<Stripe> list;
        for (std::size_t i = 0; i < at.size(); ++i) {
            list.push_back({.amplitude = at[i], .trials = 50, .overturned = overturned[i]});
        }
        return list;
    };
    expect(fit_penalised(points_of(stripes({1, 1.5, 2}, {0, 20, 50}))), 1.54065, 0.10803);
    expect(fit_penalised(points_of(stripes({1, 2}, {0, 25}))), 2.0, 0.28568);
    expect(fit_penalised(points_of(stripes({1, 2}, {25, 50}))), 1.0, 0.28568);
}

// l + ln det I / 2 of two stripes, the determinant by pairs (Cauchy and Binet): w1 w2 (u1 - u2)^2.
double penalised_likelihood(std::array<FragilityPoint, 2> const& points, double log_median, double beta) {
    double sum = 0, information = 0;
    for (auto const& point : points) {
        double const z = (point.log_intensity - log_median) / beta;
        sum += point.overturned * std::log(gsl_cdf_ugaussian_P(z))
               + (point.trials - point.overturned) * std::log(gsl_cdf_ugaussian_Q(z));
        double const density = gsl_ran_ugaussian_pdf(z);
        information += std::log(point.trials * density * density / (gsl_cdf_ugaussian_P(z) * gsl_cdf_ugaussian_Q(z)));
    }
    return sum + information / 2;
}

/// One trial above very many below: the two stripes' weights differ by any power of ten, and the penalty is still
/// found, and is a maximum.
TEST(PenalisedFit, OfLopsidedData) {
    for (std::int64_t const below : {1, 3, 41, 1000, 1000000, 1000000000}) {
        for (std::int64_t const at : {7, 12, 600}) {
            auto const points = points_of(table_of({{6, below, 0}, {at, 1, 1}}));
            auto const line = fit_penalised(points);
            ASSERT_TRUE(line) << below << ' ' << at;
            std::array const both{points[0], points[1]};
            double const best = penalised_likelihood(both, line->log_median(), line->beta());
            ASSERT_TRUE(std::isfinite(best)) << below << ' ' << at;
            for (double const step : {-1e-3, 1e-3}) {
                EXPECT_LE(penalised_likelihood(both, line->log_median() + step * line->beta(), line->beta()),
                          best + 1e-9)
                    << below << ' ' << at;
                EXPECT_LE(penalised_likelihood(both, line->log_median(), line->beta() * (1 + step)), best + 1e-9)
                    << below << ' ' << at;
            }
        }
    }
}

}  // namespace
}  // namespace overturn
