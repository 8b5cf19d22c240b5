/// The components that a generated motion may have beside the horizontal one.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/table.hpp"
#include "motion/ground_motion.hpp"

namespace overturn {

/// Name of the component's table in [waves], its place in the motion, and the number of its random stream.
struct FurtherComponent {
    char const* name;
    std::vector<double> GroundMotion::*place;
    std::uint64_t stream;
};
inline constexpr std::array further_components{FurtherComponent{"transverse", &GroundMotion::transverse_mps2, 2},
                                               FurtherComponent{"vertical", &GroundMotion::vertical_mps2, 1}};

inline constexpr config::Key ratio_key =
    config::number_key("ratio", Dimension::none, {.low = 0, .high = 10, .low_open = true},
                       "amplitude over that of the horizontal component");
inline constexpr config::Key correlation_key =
    config::number_key("correlation", Dimension::none, config::Range::between(-1, 1),
                       "coefficient of correlation with the horizontal component; not stated: independent")
        .optional();

/// Keys `transverse` and `vertical` of [waves], whose tables are `table`.
template <config::KeyTable const& table>
inline constexpr config::Key transverse_key =
    config::table_key<table>("transverse", "a second horizontal component").optional();
template <config::KeyTable const& table>
inline constexpr config::Key vertical_key = config::table_key<table>("vertical", "a vertical component").optional();

/// Key `ratio` of a component's table: its amplitude over that of the horizontal one.
[[nodiscard]] inline double read_ratio(config::Table const& table) { return table.number(ratio_key); }

/// Key `correlation` of a component's table: its coefficient with the horizontal one.
[[nodiscard]] inline std::optional<double> read_correlation(config::Table const& table) {
    return table.maybe_number(correlation_key);
}

/// Mixture of two draws of equal power that has the given correlation with the first (Cholesky factor, line by line).
template <class Lines> [[nodiscard]] Lines correlated(Lines const& first, Lines own, double correlation) {
    double const rest = std::sqrt(1 - correlation * correlation);
    for (std::size_t k = 0; k < own.size(); ++k) {
        own[k] = correlation * first[k] + rest * own[k];
    }
    return own;
}

}  // namespace overturn
