/// Randomness and uncertainty separated: the part of a fragility's beta that comes from unknown properties of the body.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stats/bootstrap.hpp"

namespace overturn {

/// One decided trial of a body whose quantities were drawn.
struct DrawnTrial {
    double log_intensity = 0;
    std::vector<double> scores;  ///< of the draws: standard normal deviates, independent of each other
    bool overturned = false;
    std::int64_t wave = 0;  ///< trials of one wave share its draws, and are not independent
};

/// The split of one resampled campaign.
struct SplitReplicate {
    double beta_u = 0;     ///< NaN: unknown
    double imbalance = 0;  ///< sum c_k (mean of z_k in the resample less that in the sample): what it moves the median
};

/// P = Phi((ln x - ln median - sum c_k z_k) / beta_r): the scores z shift the median, waves alone scatter about it.
struct BetaSplit {
    double beta_r = 0;              ///< from waves
    double beta_u = 0;              ///< sqrt(sum c_k^2), less what chance alone adds to it: from the draws
    std::vector<double> per_score;  ///< c_k = d ln median / d z_k
    std::vector<double>
        per_score_error;  ///< their standard errors, waves as independent: sandwich by waves (Liang & Zeger 1986)
    /// With waves resampled as bootstrap_waves does under the same key: replicate by replicate its partner.
    std::vector<SplitReplicate> replicates;

    /// Does anything that was drawn move the median beyond chance, at 5 % for all of it (Bonferroni)?
    [[nodiscard]] bool moves_median() const;
};

/// Maximum likelihood by Newton's method on the concave log-likelihood (Pratt 1981). Nothing if the trials hold no such
/// curve: all ended the same way, are separated, or do not overturn more at higher intensities.
/// \param key of the replicates; none are made without it
/// \pre every trial has the same number of scores, at least one
[[nodiscard]] std::optional<BetaSplit> split_beta(std::vector<DrawnTrial> const& trials,
                                                  std::optional<BootstrapKey> const& key = std::nullopt);

}  // namespace overturn
