/// The names of verdicts, as the values of a column.
#pragma once

#include <string>
#include <vector>

#include "response/registry.hpp"

namespace overturn::output {

/// In the order of verdicts().
[[nodiscard]] inline std::vector<std::string> verdict_names() {
    std::vector<std::string> names;
    for (auto const& entry : verdicts()) {
        names.emplace_back(entry.name);
    }
    return names;
}

}  // namespace overturn::output
