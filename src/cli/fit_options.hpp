/// Options that several verbs take besides a results file.
#pragma once

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "output/curve_spread.hpp"

namespace overturn::cli {

/// Checks --beta-u and --confidence (none: the campaign's). \throws InputError
inline void check_fit_options(std::optional<double> beta_u, std::optional<double> confidence) {
    if (beta_u) {
        validate(*beta_u > 0 && std::isfinite(*beta_u),
                 "--beta-u: {} (must be above 0, as statistics.beta_u). It is a lognormal standard deviation; leave "
                 "it out if it is not known",
                 *beta_u);
        output::check_spread("--beta-u", *beta_u);
    }
    constexpr double least = 0.5;
    validate(!confidence || (*confidence >= least && *confidence < 1),
             "--confidence: {} (must be at least 0.5 and below 1: an interval of less misses the true value more often "
             "than it holds it, and its ends are no bounds). State e.g. 0.95",
             confidence.value_or(0));
}

}  // namespace overturn::cli
