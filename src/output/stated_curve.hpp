/// A fragility curve that the user states, without trials: its points, in words and as JSON.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "output/json.hpp"
#include "stats/intensity_unit.hpp"
#include "stats/scores.hpp"

namespace overturn::output {

/// Without beta_u, `beta` is that of waves and of what is not known together.
struct StatedCurve {
    double median = 0;  ///< [SI]
    IntensityUnit unit;
    Dimension dimension = Dimension::none;
    double beta = 0, beta_u = 0;

    [[nodiscard]] double at(double scores) const { return median * std::exp(-scores); }
    [[nodiscard]] double composite() const { return std::hypot(beta, beta_u); }
    [[nodiscard]] double five_percent_point() const { return at(hclpf_score * beta); }
    [[nodiscard]] double one_percent_point() const { return at(one_percent_score * composite()); }
    /// Empty without beta_u.
    [[nodiscard]] std::optional<double> hclpf() const {
        return beta_u > 0 ? std::optional(at(hclpf_score * (beta + beta_u))) : std::nullopt;
    }
};

/// A line for each number that is unusual, and may be a slip.
[[nodiscard]] std::vector<std::string> warnings_of(StatedCurve const& curve);

/// "stated curve (no trials): median 0.9 g, ..."
[[nodiscard]] std::string text_of(StatedCurve const& curve);
/// `stated_curve`: its points, in its unit.
[[nodiscard]] Table stated_curve_table(StatedCurve const& curve);
/// The row of that table, and `warnings`.
[[nodiscard]] Json json_of(StatedCurve const& curve);

}  // namespace overturn::output
