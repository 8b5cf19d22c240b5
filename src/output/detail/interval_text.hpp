/// An interval as texts of results write it.
#pragma once

#include <string>

#include <fmt/format.h>

#include "stats/proportion.hpp"

namespace overturn::output {

/// "[0.0418, 0.269]".
[[nodiscard]] inline std::string interval_text(Interval const& interval) {
    return fmt::format("[{:.3g}, {:.3g}]", interval.lower, interval.upper);
}

}  // namespace overturn::output
