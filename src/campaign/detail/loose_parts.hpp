/// Parts that would move on each other before the body does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/body_spec.hpp"

namespace overturn {

/// A line for each joint that is not stated to be fastened and parts under less than tips or slides the whole body, by
/// statics: without vertical motion and before anything moves.
[[nodiscard]] std::vector<std::string> loose_parts(BodySpec const& spec);

/// The same joints in short, and those that may part later, as the body rocks: "part 1 tips on the part below at
/// 0.404 g: these numbers hold only if it is fastened".
/// \param reached the largest acceleration of the ground [m/s2]: joints that it does not part are left out; none: any
[[nodiscard]] std::vector<std::string> loose_parts_in_short(BodySpec const& spec, std::optional<double> reached_mps2);

}  // namespace overturn
