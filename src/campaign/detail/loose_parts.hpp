/// Parts that would move on each other before the body does.
#pragma once

#include <string>
#include <vector>

#include "campaign/body_spec.hpp"

namespace overturn {

/// A line for each joint that is not stated to be fastened and parts under less than tips or slides the whole body, by
/// statics: without vertical motion and before anything moves.
[[nodiscard]] std::vector<std::string> loose_parts(BodySpec const& spec);

}  // namespace overturn
