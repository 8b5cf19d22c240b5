// Requirement R-101, R-1002: whole numbers that are drawn many at a time, in vector lanes of any width, are those that
// GSL draws one by one from the same stream.
#include "stats/detail/drawn_numbers.hpp"

#include <vector>

#include <gsl/gsl_rng.h>
#include <gtest/gtest.h>

#include "simd/instruction_sets.hpp"

namespace overturn {
namespace {

// Also where most bits are thrown away.
TEST(DrawnNumbers, AreThoseThatGslDraws) {
    for (auto const set : simd::instruction_sets()) {
        simd::OnlyInstructionSet const only(set);
        for (std::uint64_t const count : {1UL, 2UL, 3UL, 250UL, 99'991UL, (1UL << 31U) + 1, (1UL << 32U) - 1}) {
            DrawnNumbers many(5, count, Purpose::bootstrap, 1, count);
            RandomStream one(5, count, Purpose::bootstrap, 1);
            std::vector<std::uint32_t> numbers(3001);
            many.draw(std::span(numbers).first(1000));
            many.draw(std::span(numbers).subspan(1000));
            for (auto const number : numbers) {
                ASSERT_EQ(number, gsl_rng_uniform_int(one.gsl(), count)) << simd::name_of(set) << " " << count;
            }
        }
    }
}

}  // namespace
}  // namespace overturn
