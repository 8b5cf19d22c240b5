// Requirement: the width of a machine's registers changes no bit.
#include "spectra/wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace overturn {
namespace {

struct Recursion {
    double* values;

    template <int bytes> OVERTURN_INLINE void run() const {
        using R = wide::Registers<bytes>;
        R x;
        R::load(x, values);
        for (int n = 0; n < 1000; ++n) {
#pragma GCC unroll 8
            for (int r = 0; r < R::count; ++r) {
                auto const plain = 3.7 * x.at[r] * (1.0 - x.at[r]) + 1e-3 * x.at[r];
                x.at[r] = wide::max(wide::fma(plain, 1e-3, 0.999 * plain), wide::fma(x.at[r], x.at[r], -1.0 * x.at[r]));
            }
        }
        R::store(values, x);
    }
};

double one(double x) {
    for (int n = 0; n < 1000; ++n) {
        double const plain = 3.7 * x * (1 - x) + 1e-3 * x;
        x = std::max(std::fma(plain, 1e-3, 0.999 * plain), std::fma(x, x, -x));
    }
    return x;
}

TEST(Wide, EveryRegisterWidthGivesTheSameBits) {
    std::array<double, wide::lanes> here{};
    for (std::size_t lane = 0; lane < wide::lanes; ++lane) {
        here.at(lane) = 0.05 + 0.05 * static_cast<double>(lane);
    }
    auto const start = here;
    auto plain = here;
    auto alone = here;
    for (double& value : alone) {
        value = one(value);
    }

    wide::dispatch(Recursion{here.data()});
    Recursion{plain.data()}.run<16>();
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
        auto middle = start;
        wide::run_avx2(Recursion{middle.data()});
        EXPECT_EQ(middle, alone);
    }
#endif

    EXPECT_EQ(here, alone);  // chaotic: one product contracted where it should not be would show
    EXPECT_EQ(plain, alone);
}

}  // namespace
}  // namespace overturn
