/// "Did you mean ...?": the nearest of the known names to a misspelt one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace overturn::config {

/// The known name nearest to `wrong` by edit distance (transpositions count one), or "" if none is near.
[[nodiscard]] std::string nearest_name(std::string_view wrong, std::span<std::string const> known);

/// " Did you mean 'x'? Known: a, b, x" or just " Known: ..." where nothing is near.
[[nodiscard]] std::string suggestion(std::string_view wrong, std::span<std::string const> known);

/// "a, b, c"
[[nodiscard]] std::string joined(std::span<std::string const> names);

}  // namespace overturn::config
