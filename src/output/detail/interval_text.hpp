/// An interval as texts of results write it: its ends rounded outward, so that it may be quoted as it stands.
#pragma once

#include <string>

#include <fmt/format.h>

#include "core/outward.hpp"
#include "stats/proportion.hpp"

namespace overturn::output {

/// "[0.0418, 0.269]".
[[nodiscard]] inline std::string interval_text(Interval const& interval) {
    return fmt::format("[{:.3g}, {:.3g}]", rounded_down(interval.lower), rounded_up(interval.upper));
}

}  // namespace overturn::output
