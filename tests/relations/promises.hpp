/// How nearly each relation is met where it is not met to the last bit.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace overturn::testing {

/// Differences over the larger value that 95 % of the trials stay below, of those that end the same way. Stated by what
/// was measured on the scenes of these tests, which are drawn by fixed seeds: some three times as much.
struct Promise {
    std::string_view relation, family;
    double flips_per_thousand = 0;  ///< trials that end otherwise
    double tilt = 0;                ///< peak_rotation
    double slip = 0;                ///< peak_slip
    double left = 0;                ///< residual_slip
    double worst = 2;               ///< largest difference of all columns that it speaks of; 2: nothing is promised
};

/// Every relation that is missing here is met by every column that it speaks of in every bit.
inline constexpr std::array promises{
    Promise{"mirror left-right", "contact corners", 0, 7e-13, 3e-12, 2e-10},
    Promise{"mirror left-right", "contact flat", 0, 4e-13, 5e-12, 6e-09},
    Promise{"mirror left-right", "contact crushed", 0, 5e-13, 2e-12, 6e-09},
    Promise{"mirror x", "space corners", 0, 2e-11, 2e-10, 2e-08},
    Promise{"mirror x", "space flat", 0, 2e-11, 3e-10, 5e-07},
    Promise{"mirror x", "space polygon", 0, 9e-13, 3e-11, 3e-09},
    Promise{"mirror y", "space corners", 0, 2e-11, 2e-10, 2e-08},
    Promise{"mirror y", "space flat", 0, 2e-11, 3e-10, 5e-07},
    Promise{"mirror y", "space polygon", 0, 8e-13, 9e-11, 3e-09},
    Promise{"mirror x and y", "space polygon", 0, 1e-12, 3e-11, 1e-09},
    Promise{"swap x and y", "space 4 points", 0, 2e-11, 1e-10, 3e-09},
    Promise{"swap x and y", "space corners", 0, 9e-12, 3e-10, 1e-08},
    Promise{"swap x and y", "space flat", 0, 2e-11, 2e-10, 6e-07},
    Promise{"swap x and y", "space rim", 0, 3e-14, 7e-13, 3e-12},
    Promise{"swap x and y", "space polygon", 0, 9e-13, 2e-10, 6e-09},
    Promise{"turn by 90 degrees", "space 4 points", 0, 2e-11, 1e-10, 3e-09},
    Promise{"turn by 90 degrees", "space corners", 0, 8e-12, 3e-10, 9e-09},
    Promise{"turn by 90 degrees", "space flat", 0, 8e-12, 3e-10, 5e-07},
    Promise{"turn by 90 degrees", "space rim", 0, 3e-14, 7e-13, 3e-12},
    Promise{"turn by 90 degrees", "space polygon", 0, 9e-13, 6e-11, 3e-09},
    Promise{"length x 4, time x 2", "space rim", 0, 0, 0, 0},
    Promise{"length x 16, time x 2, mass x 32", "space rim", 0, 0, 0, 0},
    Promise{"4 s of zeros behind", "rigid rocking", 0, 0, 0, 0, 5e-13},
    Promise{"4 s of zeros behind", "slide-rock", 0, 0, 0, 0, 4e-14},
    Promise{"4 s of zeros behind", "space 4 points", 0, 0, 0, 0, 2e-15},
    Promise{"4 s of zeros behind", "space corners", 0, 0, 0, 0, 9e-16},
    Promise{"4 s of zeros behind", "space flat", 0, 0, 0, 0, 9e-16},
    Promise{"4 s of zeros behind", "space rim", 0, 0, 0, 0, 9e-16},
    Promise{"midpoints inserted", "rigid rocking", 0, 2e-12, 0, 0},
    Promise{"midpoints inserted", "sliding", 0, 0, 6e-15, 2e-14},
    Promise{"midpoints inserted", "slide-rock", 0, 3e-13, 3e-13, 1e-12},
    Promise{"midpoints inserted", "contact 2 points", 5, 0.03, 0.3, 1},
    Promise{"midpoints inserted", "contact corners", 20, 6e-03, 0.07, 1},
    Promise{"midpoints inserted", "contact flat", 5, 0.04, 0.07, 1},
    Promise{"midpoints inserted", "contact crushed", 20, 4e-03, 0.07, 1},
    Promise{"midpoints inserted", "space 4 points", 20, 0.03, 0.3, 0.4},
    Promise{"midpoints inserted", "space corners", 10, 0.03, 0.3, 0.4},
    Promise{"midpoints inserted", "space flat", 30, 0.04, 0.3, 0.4},
    Promise{"midpoints inserted", "space rim", 0, 5e-03, 0.03, 0.2},
    Promise{"midpoints inserted", "space polygon", 20, 6e-03, 0.09, 0.4},
};

[[nodiscard]] inline std::optional<Promise> promise_of(std::string_view relation, std::string_view family) {
    for (auto const& promise : promises) {
        if (promise.relation == relation && promise.family == family) {
            return promise;
        }
    }
    return {};
}

}  // namespace overturn::testing
