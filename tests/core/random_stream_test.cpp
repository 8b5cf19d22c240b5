// Requirement R-101: randomness is a function of (seed, wave, purpose, index) alone and equals the published generator.
#include "core/random_stream.hpp"

#include <cmath>
#include <cstdint>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

namespace overturn {
namespace {

// The answer that Random123's own kat_vectors file gives for threefry4x64 with 20 rounds, counter and key all zero.
TEST(RandomStream, EqualsThePublishedKnownAnswer) {
    RandomStream stream(0, 0, Purpose::wave_phase, 0);

    EXPECT_EQ(stream.bits(), 0x09218ebde6c85537U);
    EXPECT_EQ(stream.bits(), 0x55941f5266d86105U);
    EXPECT_EQ(stream.bits(), 0x4bd25e16282434dcU);
    EXPECT_EQ(stream.bits(), 0xee29ec846bd2e40bU);
}

TEST(RandomStream, SameKeySameNumbers) {
    RandomStream a(2013, 4711, Purpose::wave_phase);
    RandomStream b(2013, 4711, Purpose::wave_phase);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(a.bits(), b.bits());
    }
}

TEST(RandomStream, EveryPartOfTheKeyMatters) {
    auto const first = [](std::uint64_t seed, std::uint64_t wave, Purpose purpose, std::uint64_t index) {
        return RandomStream(seed, wave, purpose, index).bits();
    };
    auto const base = first(1, 2, Purpose::wave_amplitude, 3);
    EXPECT_NE(base, first(2, 2, Purpose::wave_amplitude, 3));
    EXPECT_NE(base, first(1, 3, Purpose::wave_amplitude, 3));
    EXPECT_NE(base, first(1, 2, Purpose::wave_envelope, 3));
    EXPECT_NE(base, first(1, 2, Purpose::wave_amplitude, 4));
}

TEST(RandomStream, GslDistributionsWork) {
    RandomStream stream(1, 1, Purpose::wave_amplitude);
    constexpr int n = 200000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < n; ++i) {
        double const x = gsl_ran_gaussian_ziggurat(stream.gsl(), 1.0);
        sum += x;
        squares += x * x;
    }
    EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
}

TEST(RandomStream, UniformStaysBelowOne) {
    RandomStream stream(7, 0, Purpose::wave_phase);
    for (int i = 0; i < 100000; ++i) {
        double const u = gsl_rng_uniform(stream.gsl());
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
    }
}

}  // namespace
}  // namespace overturn
