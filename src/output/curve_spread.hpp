/// Usual lognormal standard deviations of a fragility curve, and those that can only be a slip.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overturn::output {

/// beta_R and beta_U of one curve, each lognormal standard deviations.
struct CurveSpread {
    double beta_r = 0;           ///< of waves; 0: no curve
    double beta_u = 0;           ///< of what is not known; 0: not known
    bool beta_r_stated = false;  ///< else found in trials
    bool beta_u_stated = false;  ///< at least a part of it; else drawn with the bodies
};

/// A line for each that is unusually wide, or stated unusually narrow, with what it does to HCLPF.
[[nodiscard]] std::vector<std::string> unusual_spread(CurveSpread const& spread);

/// \param option "--beta-u", for the message \throws InputError above any that a curve has: a percentage, or a slip
void check_spread(std::string_view option, double beta);

}  // namespace overturn::output
