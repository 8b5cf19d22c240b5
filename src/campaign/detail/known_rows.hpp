/// Known rows, compared with the wave and body as made now.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "campaign/known_trials.hpp"

namespace overturn {

/// Trials of one wave that an earlier campaign computed, checked against the wave as it was made now.
class KnownRows {
  public:
    /// \param wave as made: nothing is known of it where another motion was
    KnownRows(std::optional<KnownWave> known, WaveRow const& wave);

    /// Puts the known row in the place of one that is open yet, if they are of the same scale and the same drawn body.
    /// \param place of the trial among the wave's \return whether it did
    [[nodiscard]] bool take(std::size_t place, TrialRow& open, std::span<std::byte> extra) const;

  private:
    std::optional<KnownWave> known_;
};

}  // namespace overturn
