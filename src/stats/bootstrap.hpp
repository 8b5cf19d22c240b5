/// Scatter of the fit if the campaign were run again: fits to resampled data (Efron 1979).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stats/probit.hpp"

namespace overturn {

/// One refit. Where the resampled data hold no curve its ends say what is still known: nothing overturned puts the
/// median above all, separated data put beta at 0, anything else leaves both open.
struct Replicate {
    double log_median = 0;  ///< may be infinite; NaN: unknown
    double beta = 0;        ///< NaN: unknown
};

/// Refits to resampled data, and bias-corrected percentile intervals from them (`middle_about`).
class Bootstrap {
  public:
    /// \param line of the data themselves; \param centre the same fit as the replicates were made (cells may shift it)
    Bootstrap(std::vector<Replicate> replicates, ProbitLine const& line, ProbitLine const& centre);

    /// Takes from every replicate's ln median what is no chance of the sampling. \pre one number per replicate
    void lower_medians(std::span<double const> by);

    [[nodiscard]] Interval beta(double confidence) const;
    /// Interval of the intensity at which P is `probability`; the ends may be 0 and infinite.
    [[nodiscard]] Interval intensity(double probability, double confidence) const;
    [[nodiscard]] Interval probability(double intensity, double confidence) const;
    [[nodiscard]] std::vector<Replicate> const& replicates() const { return replicates_; }
    [[nodiscard]] std::size_t size() const { return replicates_.size(); }
    /// Number of replicates that held no curve.
    [[nodiscard]] std::size_t without_curve() const { return without_curve_; }

  private:
    std::vector<Replicate> replicates_;
    Replicate estimate_;  ///< of the data themselves
    std::size_t without_curve_ = 0;
};

/// Independent waves that a curve needs: of fewer no resample shows how much the next ones would change it.
inline constexpr std::int64_t least_waves = 5;
/// Of fewer independent waves percentiles are too short.
inline constexpr std::int64_t waves_enough_to_resample = 30;
/// Confidence at which resampled percentiles of so many waves are read to have the stated coverage: of few waves a
/// higher one, 2 Phi(t sqrt(n / (n - 1))) - 1 with Student's t of n - 1 degrees of freedom (Hesterberg 2015, The
/// American Statistician 69, 371, expanded percentile intervals). 1 of a single wave.
[[nodiscard]] double resampled_confidence(double confidence, std::int64_t waves);

/// Identifies a bootstrap's random streams: replicate r draws from (seed, r, bootstrap, stream).
struct BootstrapKey {
    std::uint64_t seed = 0;
    std::uint64_t stream = 0;
    int replicates = 1000;
};

/// Resamples waves, each with all its trials: right whether or not levels share them. More than `most_points` distinct
/// intensities are put into cells for the refits. \pre state_of(trials) is fitted
[[nodiscard]] Bootstrap bootstrap_waves(std::span<SingleTrial const> trials, ProbitLine const& line,
                                        BootstrapKey const& key);

/// Resamples the trials of every point, all independent. More than 256 points are put together for the refits. \pre
/// state_of(points) is fitted
[[nodiscard]] Bootstrap bootstrap_trials(std::span<FragilityPoint const> points, ProbitLine const& line,
                                         BootstrapKey const& key);

}  // namespace overturn
