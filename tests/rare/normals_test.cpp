// Requirement R-801, R-1002: the normals of a rare-event trial are a function of its identity alone, the same bits on
// every instruction set, and standard normal far into the tails.
#include "rare/detail/normals.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"

namespace overturn::rare {
namespace {

DrawKey const key{
    .seed = 2013, .problem = 3, .replicate = 5, .phase = Phase::pilot, .level = 7, .step = 0, .index = 11};

std::vector<double> drawn(DrawKey const& from, std::size_t count) {
    std::vector<double> normals(count);
    draw_normals(from, normals);
    return normals;
}

// radius and angle are those of Box and Muller on the words of the keyed stream.
TEST(Normals, AreBoxMullersOfTheKeyedStream) {
    auto const normals = drawn(key, 1000);
    auto words = key.stream(Purpose::rare_normals);
    for (std::size_t i = 0; i < normals.size(); i += 2) {
        double const u = 1 - std::ldexp(static_cast<double>(words.bits() >> 12U), -52);
        double const v = std::ldexp(static_cast<double>(words.bits() >> 12U), -52);
        double const r = std::sqrt(-2 * std::log(u));
        ASSERT_NEAR(normals[i], r * std::cos(2 * std::numbers::pi * v), 2e-14) << i;
        ASSERT_NEAR(normals[i + 1], r * std::sin(2 * std::numbers::pi * v), 2e-14) << i;
    }
}

// R-1002: the machine's instruction set changes no bit.
TEST(Normals, SameBitsOnEveryInstructionSet) {
    auto const best = drawn(key, 2051);
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        EXPECT_EQ(drawn(key, 2051), best) << simd::name_of(set);
    }
}

// fewer normals of a trial are the first ones of more.
TEST(Normals, FewerAreTheFirstOfMore) {
    auto const many = drawn(key, 100);
    for (std::size_t const count : {1U, 2U, 31U, 32U, 33U, 64U, 99U}) {
        auto const few = drawn(key, count);
        EXPECT_EQ(few, std::vector<double>(many.begin(), many.begin() + static_cast<std::ptrdiff_t>(count)));
    }
}

// every part of the identity has numbers of its own.
TEST(Normals, EveryPartOfTheIdentityMatters) {
    std::set<double> firsts;
    for (auto change : {0, 1, 2, 3, 4, 5, 6, 7}) {
        auto other = key;
        other.seed += change == 1 ? 1 : 0;
        other.problem += change == 2 ? 1 : 0;
        other.replicate += change == 3 ? 1 : 0;
        other.phase = change == 4 ? Phase::final : other.phase;
        other.level += change == 5 ? 1 : 0;
        other.step += change == 6 ? 1 : 0;
        other.index += change == 7 ? 1 : 0;
        firsts.insert(drawn(other, 1).front());
    }
    EXPECT_EQ(firsts.size(), 8U);
}

// moments and tail counts of four million normals are a normal's within 4.5 standard errors.
TEST(Normals, AreStandardNormalIntoTheTails) {
    constexpr std::size_t keys = 2000;
    constexpr std::size_t each = 2048;
    double const n = keys * each;
    double sum = 0;
    double squares = 0;
    double neighbours = 0;
    std::vector<double> const beyond{1, 2, 3, 4, 4.5};
    std::vector<double> count(beyond.size(), 0.0);
    for (std::uint64_t i = 0; i < keys; ++i) {
        auto const x = drawn({.seed = 1, .index = i}, each);
        for (std::size_t j = 0; j < each; ++j) {
            sum += x[j];
            squares += x[j] * x[j];
            neighbours += j > 0 ? x[j] * x[j - 1] : 0;
            for (std::size_t b = 0; b < beyond.size(); ++b) {
                count[b] += x[j] > beyond[b] ? 1 : 0;
            }
        }
    }
    EXPECT_NEAR(sum / n, 0, 4.5 / std::sqrt(n));
    EXPECT_NEAR(squares / n, 1, 4.5 * std::sqrt(2 / n));
    EXPECT_NEAR(neighbours / n, 0, 4.5 / std::sqrt(n));
    for (std::size_t b = 0; b < beyond.size(); ++b) {
        double const expected = n * gsl_cdf_ugaussian_Q(beyond[b]);
        EXPECT_NEAR(count[b], expected, 4.5 * std::sqrt(expected)) << beyond[b];
    }
}

}  // namespace
}  // namespace overturn::rare
