/// Effect of the number of waves: uncertainty of P(overturn), its cost, and whether sampling or arithmetic limits a
/// campaign's accuracy.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cost/bench.hpp"
#include "cost/comparison.hpp"

namespace overturn::cost {

/// A part of the sample, run as a campaign of its own.
struct SubsetPoint {
    std::int64_t waves = 0;
    double seconds = 0;       ///< CPU: made, measured, tried
    double width = 0;         ///< of the Clopper-Pearson interval of the decided trials, mean over all stripes
    double root_n_width = 0;  ///< the largest subset's width times sqrt(its waves / waves)
};

struct Sampling {
    std::vector<SubsetPoint> subsets;  ///< growing
    std::int64_t stripes = 0;
    double probability = 0;  ///< mean over all stripes of the sample
    double half_width = 0;  ///< mean over all stripes, at the campaign's number of waves and the sample's probabilities
    double seconds = 0;     ///< CPU of the whole campaign at the sample's pace
};

/// Runs growing parts of `numbers`, the waves of a sample.
[[nodiscard]] Sampling study_sampling(CampaignSpec const& spec, Plan const& plan,
                                      std::vector<std::int64_t> const& numbers);

/// The larger of the two errors.
enum class Dominates { sampling, numerical, unknown };

/// Numerical against sampling error of P(overturn), both as means over all stripes.
struct Balance {
    Dominates dominates = Dominates::unknown;
    double numerical = 0;   ///< overturning flips over trials; without flips the upper bound of their share
    bool is_bound = false;  ///< no flip was seen
    double sampling = 0;    ///< half width
    double factor = 0;      ///< the larger over the smaller; at least that if numerical is a bound
};

/// \param defaults the campaign's own setting against the reference
[[nodiscard]] Balance balance_of(Comparison const& defaults, double half_width, double confidence);

/// Whether the accuracy of the campaign's settings suffices, and by how much.
[[nodiscard]] std::string sentence_of(Balance const& balance, Comparison const& defaults, CampaignSpec const& spec,
                                      std::int64_t stripes);

}  // namespace overturn::cost
