/// Standards' rules that convert a response spectrum from one damping ratio to another. Never applied unless requested.
#pragma once

#include <span>

#include "config/registry.hpp"

namespace overturn {

/// Ordinate at a damping ratio over that at 5 %, the same at every period.
/// \throws InputError for a ratio outside the rule's own range.
using DampingRule = double (*)(double damping);

/// japan: 1.5 / (1 + 10 h), notification 1457 (2000) of the ministry of construction. eurocode-8: sqrt(10 / (5 + 100
/// h)) and not below 0.55, EN 1998-1 (2004), eq. 3.6: h to 0.28.
[[nodiscard]] std::span<config::Entry<DampingRule> const> damping_rules();

}  // namespace overturn
