/// Looking into what may crash those who look.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace overturn::store {

/// What `look` returns, computed in a process of its own: HDF5 may crash over, or never come back from, a damaged file.
/// Nothing if it did, or if there can be no such process.
[[nodiscard]] std::optional<std::string> looked_at_apart(std::function<std::string()> const& look);

}  // namespace overturn::store
