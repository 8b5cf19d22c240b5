/// Who a draw belongs to: the identity of one trial of an estimator, from which all its random numbers follow.
#pragma once

#include <cstdint>

#include "core/random_stream.hpp"

namespace overturn::rare {

/// Purpose of a stage of an estimator. Values are part of what a seed means: never renumber them.
enum class Phase : std::uint64_t { scout = 1, crude = 2, pilot = 3, final = 4, subset = 5 };

/// A trial by (seed, problem, replicate, stage, index): never by rank, order or how often something was accepted.
struct DrawKey {
    std::uint64_t seed = 0;
    std::uint64_t problem = 0;    ///< number of the limit state in its campaign, below 2^24
    std::uint64_t replicate = 0;  ///< below 2^12
    Phase phase = Phase::crude;
    std::uint64_t level = 0;  ///< stage of the pilot runs, or level of a subset simulation, below 2^12
    std::uint64_t step = 0;   ///< of a Markov chain, below 2^12
    std::uint64_t index = 0;  ///< of the trial within its stage

    /// All but seed and index in one number.
    [[nodiscard]] std::uint64_t stage() const {
        constexpr unsigned width = 12;
        auto const which = static_cast<std::uint64_t>(phase) << 2 * width | problem;
        return ((which << width | replicate) << width | level) << width | step;
    }
    [[nodiscard]] StreamKey key(Purpose purpose) const { return {seed, index, purpose, stage()}; }
    [[nodiscard]] RandomStream stream(Purpose purpose) const { return RandomStream(key(purpose)); }
};

}  // namespace overturn::rare
