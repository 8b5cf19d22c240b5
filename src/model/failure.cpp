#include "model/failure.hpp"

#include <array>

namespace overturn {

std::span<FailureEntry const> failures() {
    static constexpr std::array entries{
        FailureEntry{FailureReason::none, "none", "it has a verdict"},
        FailureEntry{FailureReason::wave_failed, "wave-failed", "the wave could not be made"},
        FailureEntry{FailureReason::wave_cannot_be_scaled, "wave-cannot-be-scaled",
                     "the wave is zero in the level's measure"},
        FailureEntry{FailureReason::no_convergence, "no-convergence", "no step was short enough"},
        FailureEntry{FailureReason::out_of_range, "absurd-level", "shaking beyond a million g"},
        FailureEntry{FailureReason::wave_not_accepted, "wave-not-accepted", "the wave misses waves.acceptance"}};
    return entries;
}

FailureEntry const& entry_of(FailureReason reason) { return failures()[static_cast<std::size_t>(reason)]; }

}  // namespace overturn
