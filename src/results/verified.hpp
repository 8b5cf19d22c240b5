/// Result of computing rows of a finished file again.
#pragma once

#include <cstdint>
#include <string>

namespace overturn {

/// Rows computed again, and how many of them differ in any bit from the stored ones.
struct Verified {
    std::int64_t trials = 0, waves = 0, rare = 0;
    std::int64_t stored_trials = 0, stored_waves = 0, stored_rare = 0;  ///< that the file has
    std::int64_t differing_trials = 0, differing_waves = 0, differing_rare = 0;
    std::string first;  ///< "trial 17 (wave 0, type-b, 600 gal): v_wes, v_resp"; empty if nothing differs

    [[nodiscard]] bool all_equal() const { return first.empty(); }
};

}  // namespace overturn
