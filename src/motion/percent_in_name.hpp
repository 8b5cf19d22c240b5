/// Percentages in the name or the text of a spectrum: a damping, or a hazard's probability of exceedance.
#pragma once

#include <string>
#include <string_view>

namespace overturn {

/// With blanks in place of each hazard level, "2 % in 50 years", "10% PoE", "2%/50yr", "probability of exceedance 2 %":
/// as long as before. Case does not count.
[[nodiscard]] std::string without_hazard_levels(std::string_view text);

/// Nothing but a damping of 30 % at most: "2%", "@ 5 % damping", "10 percent damped", "5% of critical"?
/// \param lower in lower case
[[nodiscard]] bool is_damping_alone(std::string_view lower);

}  // namespace overturn
