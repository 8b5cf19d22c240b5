/// Why a trial has no verdict: stated by the function that could not go on, never guessed from numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace overturn {

/// Stored in results files: never renumber.
enum class FailureReason : std::int64_t {
    none = 0,
    wave_failed = 1,
    wave_cannot_be_scaled = 2,
    no_convergence = 3,
    out_of_range = 4,
    wave_not_accepted = 5
};

struct FailureEntry {
    FailureReason value;
    std::string_view name;     ///< "no-convergence"
    std::string_view summary;  ///< one line: what it is and what to do
};

/// In the order of the enumeration.
[[nodiscard]] std::span<FailureEntry const> failures();
[[nodiscard]] FailureEntry const& entry_of(FailureReason reason);

}  // namespace overturn
