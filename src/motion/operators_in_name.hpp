/// Does a column's name say that its numbers were made of others?
#pragma once

#include <string_view>

namespace overturn {

/// "a [gal]/10", "Sa [g] x 0.5", "a^2", "|a|", "ax+ay", "Sa/R [g]": an operator in a column's name, in any case, or
/// anything but letters behind its unit; "half", "resultant", "SRSS", "rel", "res" or "beta" as a word of it. A unit's
/// own slash and those of "N/S", "E/W" are none.
[[nodiscard]] bool tells_operation_in_name(std::string_view name);

}  // namespace overturn
