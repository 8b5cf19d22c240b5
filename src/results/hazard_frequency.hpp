/// How often in a year each limit state of a campaign is passed, by a hazard curve of the site.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/analysis.hpp"
#include "results/statistics.hpp"
#include "stats/hazard.hpp"

namespace overturn {

/// A table of two columns under a line of names, "pga [gal], annual_exceedance": the levels' own measure with its unit,
/// and the mean number of exceedances in a year. `#` begins a comment. \throws InputError with `name:line` at what is
/// none, is of another measure, states no unit of it, or does not rise and fall as a hazard curve does
[[nodiscard]] HazardCurve parse_hazard(std::string_view content, std::string const& name, LevelSpec const& levels);

/// Of one body and limit state. All frequencies in 1/a.
struct BodyFrequency {
    std::string body, limit;
    /// By the curve over the levels with beta_R and beta_U together, if there is a curve: their mean.
    std::optional<AnnualFrequency> mean;
    /// Of that mean, from refits to resampled waves or trials, with undecided trials as either extreme; where the curve
    /// does not describe the data, or might not with them, as far as the stripes alone allow too.
    Interval interval;
    bool poor = false;           ///< the curve does not describe the data
    std::int64_t few_waves = 0;  ///< independent ones, where they are too few to resample; else 0
    /// Where beta_U is known: the frequency by the curves at 5, 50 and 95 % confidence, median exp(-+1.645 beta_U).
    struct Fractiles {
        double low = 0, median = 0, high = 0;
    };
    std::optional<Fractiles> fractiles;
    Interval seen;                          ///< from the stripes alone (annual_frequency_seen), likewise
    double nothing_below = 0;               ///< intensity up to which no motion moves the body, if known [SI]
    double seen_below_levels = 0;           ///< of the upper end of `seen`: by motions weaker than all levels
    std::optional<FrequencyShares> shares;  ///< of the mean: below, between and above the levels that were tried
};

[[nodiscard]] std::vector<BodyFrequency> frequencies_of(CampaignSpec const& spec, Statistics const& statistics,
                                                        std::vector<BodyAnalysis> const& analysis,
                                                        HazardCurve const& hazard, double confidence);

/// For the terminal, the hazard curve's ends in the unit it states, with what lies outside what was tried or stated.
[[nodiscard]] std::string frequency_table(CampaignSpec const& spec, std::vector<BodyFrequency> const& frequencies,
                                          HazardCurve const& hazard, double confidence);

}  // namespace overturn
