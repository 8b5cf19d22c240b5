/// Looking into what may crash those who look.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace overturn::store {

/// Result of `look`, computed in a process of its own: HDF5 may crash over a damaged file, or never come back from it.
/// Nothing if it did, or if there can be no such process.
[[nodiscard]] std::optional<std::string> looked_at_apart(std::function<std::string()> const& look);

}  // namespace overturn::store
