/// The versions of the results file, and what is known to be wrong in each.
#pragma once

#include <cstdint>
#include <string>

namespace overturn::store {

/// What is known of files of this version, in one line, beginning with a blank; empty if nothing is. Each says which
/// results it touches.
[[nodiscard]] std::string known_errors_of(std::int64_t version);

}  // namespace overturn::store
