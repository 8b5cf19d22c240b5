/// Trials whose rows are known before their wave is made: of an earlier campaign, of which this one is a larger one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "campaign/rows.hpp"

namespace overturn {

/// Known rows of one wave.
struct KnownWave {
    WaveRow row;
    TrialRows trials;         ///< in the plan's order; default rows where not known
    std::vector<bool> known;  ///< true for those that are known
};

/// Source of known trials, asked before trials are computed. The caller compares its rows with the wave and the body
/// that it made: rows of another motion, scale or draw are not taken.
class KnownTrials {
  public:
    virtual ~KnownTrials() = default;
    KnownTrials(KnownTrials const&) = delete;
    KnownTrials& operator=(KnownTrials const&) = delete;
    KnownTrials(KnownTrials&&) = delete;
    KnownTrials& operator=(KnownTrials&&) = delete;

    /// Nothing where no trial of that wave of the plan is known. \throws SystemError if it cannot be read
    [[nodiscard]] virtual std::optional<KnownWave> of(std::int64_t wave) const = 0;

  protected:
    KnownTrials() = default;
};

}  // namespace overturn
