// Requirement: the width of a machine's registers changes no bit.
#include "spectra/wide.hpp"

#include <array>

#include <gtest/gtest.h>

namespace overturn {
namespace {

struct Recursion {
    double* values;

    template <int bytes> OVERTURN_INLINE void run() const {
        wide::Registers<bytes> x;
        wide::Registers<bytes>::load(x, values);
        for (int n = 0; n < 1000; ++n) {
#pragma GCC unroll 8
            for (int r = 0; r < wide::Registers<bytes>::count; ++r) {
                x.at[r] = 3.7 * x.at[r] * (1.0 - x.at[r]) + 1e-3 * x.at[r];
            }
        }
        wide::Registers<bytes>::store(values, x);
    }
};

TEST(Wide, EveryRegisterWidthGivesTheSameBits) {
    std::array<double, wide::lanes> here{};
    for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
        here.at(lane) = 0.05 + 0.05 * static_cast<double>(lane);
    }
    auto plain = here;
    auto middle = here;

    wide::dispatch(Recursion{here.data()});
    Recursion{plain.data()}.run<16>();
    Recursion{middle.data()}.run<32>();

    EXPECT_EQ(here, plain);  // chaotic: one contracted product would show
    EXPECT_EQ(here, middle);
}

}  // namespace
}  // namespace overturn
