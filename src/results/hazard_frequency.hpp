/// Annual frequency of each limit state of a campaign, by a hazard curve of the site.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/analysis.hpp"
#include "results/hazard_table.hpp"
#include "results/statistics.hpp"
#include "stats/hazard.hpp"
#include "stats/hazard_bounds.hpp"

namespace overturn {

/// Annual frequency of one body and limit state. All frequencies in 1/a.
struct BodyFrequency {
    std::string body, limit;
    std::string full_name;  ///< name of the limit state in lines; empty: its name
    /// By the curve over the levels with beta_R and beta_U together, if there is a curve: their mean, the curve taken
    /// to hold outside of the levels too.
    std::optional<AnnualFrequency> mean;
    /// The answer by the curve. Its lower end counts no motion below the levels, and those above levels and hazard
    /// curve as passing it as often as at their end; its upper end counts those above as passing it always, those below
    /// as often as the curve allows (FrequencyBounds). From refits to resampled waves or trials, with undecided trials
    /// as either extreme; where the curve does not describe the data, or might not with them, as far as the stripes
    /// alone allow too. Without a beta_U it has no upper end (infinite): a wider curve is passed more often.
    Interval interval;
    FrequencyBounds bounds;  ///< the parts of both ends, by the curve itself
    double continued = 0;    ///< estimate: the hazard curve continued beyond its ends at its slopes there
    std::optional<WidePiece> wide;
    bool poor = false;           ///< the curve does not describe the data
    std::int64_t few_waves = 0;  ///< independent ones, where they are too few to resample; else 0
    /// Frequency by the curves at 5, 50 and 95 % confidence, median exp(-+1.645 beta_U), where beta_U is known.
    struct Fractiles {
        double low = 0, median = 0, high = 0;
        /// The answer at 95 % confidence: upper end of `high` by refits, trials without a verdict and motions outside
        /// of levels and hazard curve as for `interval`, and no lower than the upper end of that.
        double most = 0;
    };
    std::optional<Fractiles> fractiles;
    /// From the stripes alone (annual_frequency_seen), likewise, with a stated beta_U; the upper end with the hazard
    /// continued (from_lower_on)
    Interval seen;
    bool outside_seen = false;       ///< the mean of the curve is not within what the stripes show
    double nothing_below = 0;        ///< intensity up to which no motion moves the body, if known [SI]
    double lowest = 0, highest = 0;  ///< intensities that were tried [SI]
    double seen_below_curve = 0;     ///< of the upper end of `seen`: by motions weaker than the hazard curve's first
    double seen_below_levels = 0;    ///< of the upper end of `seen`: by motions weaker than all levels
    std::optional<FrequencyShares> shares;  ///< of the mean: below, between and above the levels that were tried
    bool stated = false;                    ///< no trials: the curve is stated, and `interval` bounds the hazard alone

    /// Neither drawn nor stated, so that nothing has an upper end. A curve shows whether what was drawn matters;
    /// without one, whatever was drawn counts.
    bool lacks_beta_u = false;

    /// The answer: by the curve, or by the stripes alone.
    [[nodiscard]] Interval const& ends() const { return mean ? interval : seen; }
    /// Part of the mean from motions outside of the levels, or of the hazard curve.
    [[nodiscard]] double extrapolated() const;
};

/// Frequency of one fit. \param nothing_below as in BodyFrequency
[[nodiscard]] BodyFrequency frequency_of(FragilityFit const& fit, FragilityData const& stripes,
                                         HazardCurve const& hazard, double confidence, double nothing_below);

/// Frequency of a stated curve: beta_R, and beta_U beside it (0: not known).
[[nodiscard]] BodyFrequency frequency_of_stated(double median, double beta_r, double beta_u, HazardCurve const& hazard);

/// Not known (NaN) where the waves are no sample.
[[nodiscard]] std::vector<BodyFrequency> frequencies_of(CampaignSpec const& spec, Statistics const& statistics,
                                                        std::vector<BodyAnalysis> const& analysis,
                                                        HazardCurve const& hazard, double confidence);

}  // namespace overturn
