/// Tolerances have names and say what kind of truth they hold a number to.
#pragma once

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace overturn::testing {

struct Tolerance {
    double relative;
    char const* name;
};

inline constexpr Tolerance rounding{1e-14, "rounding"};             ///< the same sum in another order
inline constexpr Tolerance exact_formula{1e-12, "exact_formula"};   ///< closed form against closed form
inline constexpr Tolerance integrated{1e-9, "integrated"};          ///< converged time stepping against closed form
inline constexpr Tolerance printed_digits{5e-7, "printed_digits"};  ///< a number known to six or seven digits
inline constexpr Tolerance published{2e-2, "published"};            ///< a number read from a printed figure or table

inline ::testing::AssertionResult near(double computed, double reference, Tolerance const& allowed, double scale = 0) {
    double const size = scale > 0 ? scale : std::abs(reference);
    double const error = std::abs(computed - reference) / (size > 0 ? size : 1.0);
    if (error <= allowed.relative) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << fmt::format("{:.17g} instead of {:.17g}: error {:.3g}, allowed {} = {:g}",
                                                        computed, reference, error, allowed.name, allowed.relative);
}

}  // namespace overturn::testing
