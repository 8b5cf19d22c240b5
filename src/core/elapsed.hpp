/// Time on the wall, for progress and for what things cost: never in a result.
#pragma once

#include <chrono>

namespace overturn {

using Clock = std::chrono::steady_clock;

[[nodiscard]] inline double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// When this program began, after its libraries were loaded.
[[nodiscard]] Clock::time_point program_begin();

}  // namespace overturn
