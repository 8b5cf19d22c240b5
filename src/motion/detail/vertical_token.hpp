/// A word of the vertical anywhere in a line of prose, also within a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// "Z-component of acceleration", "Record name ABCHNZ", "20110311_MYG004.UD": the word of the line that names the
/// vertical, between all that is no letter or figure; empty where there is none, or where the line names a horizontal
/// one, too. "altitude Z" is none. \param lower a line in lower case
[[nodiscard]] std::string vertical_token_in(std::string_view lower);

/// "EW", "U-D", "HNE" in capitals: points of the compass that a line names, whatever else it says.
[[nodiscard]] std::vector<std::string> compass_words_in(std::string_view line);

}  // namespace overturn
