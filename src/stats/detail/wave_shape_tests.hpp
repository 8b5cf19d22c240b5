/// The tests of a curve's shape where trials share waves: waves are resampled, each with all its trials.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stats/bootstrap.hpp"
#include "stats/detail/wave_cells.hpp"
#include "stats/fragility_data.hpp"

namespace overturn {

/// Counts per wave at up to 64 intensities. What is resampled scatters about the data; moved onto what the null
/// hypothesis says of them, it shows how far data of it would be off.
class WaveShapeTests {
  public:
    /// \param line the fitted curve, if there is one
    WaveShapeTests(std::span<SingleTrial const> trials, std::optional<ProbitLine> const& line, BootstrapKey const& key);

    /// Chance of so much fall below the rising estimate.
    [[nodiscard]] double monotone_chance() const;
    /// Chance of proportions so far from the curve, by Pearson's sum over intensities pooled until five or more waves
    /// are expected to fall and to stand. 1 where fewer than three are left, or there is no curve.
    [[nodiscard]] double misfit_chance() const;

  private:
    /// The waves drawn anew; their number stays. Intensities at which a draw holds none keep the data's own proportion.
    [[nodiscard]] std::vector<FragilityPoint> draw(WaveResamples& resamples, int number) const;

    WaveCells cells_;
    std::vector<FragilityPoint> points_;
    std::optional<ProbitLine> line_;  ///< of these points
    BootstrapKey key_;
};

}  // namespace overturn
