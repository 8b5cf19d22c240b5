// Requirement R-202: Fourier transforms of any length agree with their sums and repeat bit for bit.
#include "spectra/transform.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include "core/random_stream.hpp"
#include "core/units.hpp"

namespace overturn {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> noise(std::size_t count) {
    RandomStream stream(7, count, Purpose::wave_phase);
    std::vector<Complex> values(count);
    for (auto& value : values) {
        value = {gsl_rng_uniform(stream.gsl()) - 0.5, gsl_rng_uniform(stream.gsl()) - 0.5};
    }
    return values;
}

Complex direct(std::vector<Complex> const& values, std::size_t k, double sign) {
    Complex sum = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        double const turns = static_cast<double>(k * n % values.size()) / static_cast<double>(values.size());
        sum += values[n] * std::polar(1.0, sign * 2 * pi * turns);
    }
    return sum;
}

class Transforms : public ::testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] double tolerance() const { return 1e-15 * static_cast<double>(GetParam() + 8); }
};

TEST_P(Transforms, ComplexOnesAreTheirSums) {
    auto const values = noise(GetParam());
    for (double const sign : {-1.0, 1.0}) {
        auto const transform = sign < 0 ? forward_transform(GetParam()) : backward_transform(GetParam());
        ASSERT_EQ(transform.in.size(), GetParam());
        ASSERT_EQ(transform.out.size(), GetParam());
        std::ranges::copy(values, transform.in.begin());
        transform.run();
        for (std::size_t k = 0; k < values.size(); ++k) {
            EXPECT_LT(std::abs(transform.out[k] - direct(values, k, sign)), tolerance()) << sign << " " << k;
        }
    }
}

TEST_P(Transforms, RealOnesAreHalfOfThem) {
    auto values = noise(GetParam());
    for (auto& value : values) {
        value = value.real();
    }
    auto const analysis = real_analysis(GetParam());
    ASSERT_EQ(analysis.out.size(), GetParam() / 2 + 1);
    std::ranges::transform(values, analysis.in.begin(), [](Complex const& value) { return value.real(); });
    analysis.run();
    for (std::size_t k = 0; k < analysis.out.size(); ++k) {
        EXPECT_LT(std::abs(analysis.out[k] - direct(values, k, -1)), tolerance()) << k;
    }

    auto const synthesis = real_synthesis(GetParam());
    std::ranges::copy(analysis.out, synthesis.in.begin());
    synthesis.run();
    for (std::size_t n = 0; n < values.size(); ++n) {
        EXPECT_NEAR(synthesis.out[n] / static_cast<double>(GetParam()), values[n].real(), tolerance()) << n;
    }
}

TEST_P(Transforms, RepeatBitForBit) {
    auto const values = noise(GetParam());
    auto const once = [&] {
        auto const transform = forward_transform(GetParam());
        std::ranges::copy(values, transform.in.begin());
        transform.run();
        return std::vector<Complex>(transform.out.begin(), transform.out.end());
    };
    auto const first = once();
    for (std::size_t other = 100; other < 120; ++other) {
        (void)forward_transform(other);  // more lengths than are kept: the plan is made anew
    }
    EXPECT_EQ(once(), first);
}

INSTANTIATE_TEST_SUITE_P(Lengths, Transforms, ::testing::Values(1, 2, 3, 8, 15, 97, 240, 1024));

}  // namespace
}  // namespace overturn
