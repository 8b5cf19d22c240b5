// Requirement R-304: sampling by slices visits every slice once, in an order that the seed alone decides.
#include "core/keyed_permutation.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

namespace overturn {
namespace {

KeyedPermutation keyed(std::uint64_t count, std::uint64_t seed = 1, std::uint64_t index = 0) {
    return {seed, 0, Purpose::body_scatter, index, count};
}

std::vector<std::uint64_t> places(KeyedPermutation const& permutation, std::uint64_t count) {
    std::vector<std::uint64_t> all(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        all[i] = permutation(i);
    }
    return all;
}

TEST(KeyedPermutation, TakesEveryPlaceOnce) {
    for (std::uint64_t count = 1; count <= 300; ++count) {
        auto taken = places(keyed(count), count);
        std::sort(taken.begin(), taken.end());
        std::vector<std::uint64_t> all(count);
        std::iota(all.begin(), all.end(), 0U);
        ASSERT_EQ(taken, all) << count;
    }
}

TEST(KeyedPermutation, OfHugeCountsStaysWithin) {
    constexpr std::uint64_t count = 1'000'000'000'000;
    auto const permutation = keyed(count);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        EXPECT_LT(permutation(count - 1 - i), count);
    }
}

TEST(KeyedPermutation, IsAnotherForAnyOtherKey) {
    constexpr std::uint64_t count = 1000;
    auto const one = places(keyed(count), count);

    EXPECT_EQ(one, places(keyed(count), count));
    EXPECT_NE(one, places(keyed(count, 2), count));
    EXPECT_NE(one, places(keyed(count, 1, 1), count));
    EXPECT_NE(one, places(KeyedPermutation(1, 1, Purpose::body_scatter, 0, count), count));
    EXPECT_NE(one, places(KeyedPermutation(1, 0, Purpose::friction_scatter, 0, count), count));
}

// Property: over many keys every pair of neighbours is equally likely to land in each of 12 x 11 ordered places.
TEST(KeyedPermutation, OrdersNeighboursAsIfShuffled) {
    constexpr std::uint64_t count = 12;
    constexpr std::uint64_t keys = 66000;
    std::vector<double> seen(count * count);
    for (std::uint64_t seed = 0; seed < keys; ++seed) {
        auto const permutation = keyed(count, seed);
        seen[permutation(4) * count + permutation(5)] += 1;
    }
    double const expected = static_cast<double>(keys) / (count * (count - 1));
    double chi_square = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        for (std::uint64_t j = 0; j < count; ++j) {
            double const off = seen[i * count + j] - (i == j ? 0 : expected);
            chi_square += off * off / expected;
        }
    }
    double const p = gsl_cdf_chisq_Q(chi_square, count * (count - 1) - 1);
    EXPECT_GT(p, 1e-3);
}

}  // namespace
}  // namespace overturn
