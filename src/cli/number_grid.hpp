/// Several numbers as one option: "1,2,5", or "0.5:10:40" for so many in equal ratios.
#pragma once

#include <string_view>
#include <vector>

namespace overturn::cli {

/// At least one number, each from `least`, above 0, to `most`; at most 2000 by first:last:count.
/// \param option names it in messages \throws InputError
[[nodiscard]] std::vector<double> number_grid(std::string_view text, char const* option, double least, double most);

}  // namespace overturn::cli
