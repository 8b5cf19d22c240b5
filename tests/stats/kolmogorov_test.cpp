// Requirement R-904: distributions are compared as a whole, against Kolmogorov's band: what is drawn from one
// distribution stays inside as often as the band says, what is not leaves it.
#include "support/kolmogorov.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include "core/random_stream.hpp"
#include "support/tolerance.hpp"

namespace overturn {
namespace {

using testing::ks_distance;
using testing::ks_p_value;
using testing::ks_test;

std::vector<double> normals(int count, std::uint64_t repetition, std::uint64_t index, double shift = 0) {
    RandomStream stream(8, repetition, Purpose::body_scatter, index);
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(shift + gsl_ran_ugaussian(stream.gsl()));
    }
    return values;
}

TEST(Kolmogorov, DistanceByHand) {
    EXPECT_EQ(ks_distance({1, 2, 3}, {1, 2, 3}), 0);
    EXPECT_EQ(ks_distance({1, 2}, {3, 4}), 1);
    EXPECT_EQ(ks_distance({4, 1, 3, 2}, {5, 3}), 0.5) << "unsorted, of different sizes";
    EXPECT_EQ(ks_distance({1, 2, 3, 4}, {3, 4, 5, 6}), 0.5);
    EXPECT_EQ(ks_distance({1, 1, 1, 2}, {1, 2, 2, 2}), 0.5) << "ties step together";
    EXPECT_EQ(ks_distance(std::vector{0.25}, [](double x) { return x; }), 0.75);
    EXPECT_EQ(ks_distance(std::vector{0.875}, [](double x) { return x; }), 0.875) << "below the step, too";
    EXPECT_TRUE(std::isnan(ks_distance({}, std::vector{1.0})));
}

/// The asymptotic distribution (Smirnov 1948): 5 % beyond 1.358, 1 % beyond 1.628. At size 1e12 the correction is gone.
TEST(Kolmogorov, CriticalValuesAsPublished) {
    EXPECT_NEAR(ks_p_value(1.3581e-6, 1e12), 0.05, 1e-4);
    EXPECT_NEAR(ks_p_value(1.6276e-6, 1e12), 0.01, 1e-4);
    EXPECT_NEAR(ks_p_value(1.2238e-6, 1e12), 0.10, 1e-4);
    EXPECT_EQ(ks_p_value(0, 100), 1);
    // The exact 5 % point of 10 values is 0.40925 (Miller 1956).
    EXPECT_NEAR(ks_p_value(0.40925, 10), 0.05, 0.001);
}

/// 5 % of 2000 samples leave the 95 % band: 100 with a standard deviation of 10.
TEST(Kolmogorov, TheBandHasItsCoverage) {
    int outside_one = 0;
    int outside_two = 0;
    for (std::uint64_t r = 0; r < 2000; ++r) {
        auto const one = ks_test(normals(60, r, 0), gsl_cdf_ugaussian_P);
        auto const two = ks_test(normals(60, r, 1), normals(90, r, 2));
        outside_one += one.distance > one.band ? 1 : 0;
        outside_two += two.distance > two.band ? 1 : 0;
        EXPECT_EQ(one.distance > one.band, one.p_value < 0.05);
    }
    EXPECT_NEAR(outside_one, 100, 35);
    EXPECT_NEAR(outside_two, 100, 35);
}

TEST(Kolmogorov, AnotherDistributionLeavesTheBand) {
    auto const shifted = ks_test(normals(400, 0, 0), normals(400, 0, 1, 0.5));

    EXPECT_GT(shifted.distance, shifted.band);
    EXPECT_LT(shifted.p_value, 1e-4);
}

}  // namespace
}  // namespace overturn
