/// The versions of the results file, and what is known to be wrong in each.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace overturn::store {

/// Known errors of files of this version, in one line, beginning with a blank; empty if none are. Each says which
/// results it touches.
[[nodiscard]] std::string known_errors_of(std::int64_t version);

/// The format whose files first held a column; of those that stood in the oldest that is read, that.
/// \param group without a slash before it, bodies and limit states by "<body>" and "<limit>": "stripes/<body>"
[[nodiscard]] std::int64_t first_format_of(std::string_view group, std::string_view column);

}  // namespace overturn::store
