/// The trials of a campaign to inspect: where a body first fell, how near it came, what contradicts itself.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "model/verdict.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Why to inspect a trial.
enum class TellingKind : std::uint8_t {
    first_overturned,  ///< fell at the lowest level of all; of several the one with the lowest number
    nearest_miss,      ///< highest peak rotation of those that moved and stood
    largest_slip,      ///< of those that stood
    non_monotonic      ///< stood at a higher level than one at which the same wave overturned the body
};

/// "first-overturned", "nearest-miss", "largest-slip", "non-monotonic", by their places.
inline constexpr std::array<std::string_view, 4> telling_kinds{"first-overturned", "nearest-miss", "largest-slip",
                                                               "non-monotonic"};

/// Largest number of trials of the last kind, for a body.
inline constexpr std::size_t most_non_monotonic = 3;

struct TellingTrial {
    TellingKind kind = TellingKind::first_overturned;
    std::int64_t trial = 0;  ///< number of its row
    std::int64_t wave = 0, body = 0, level = 0;
    double amplitude = 0;  ///< of the level, SI
    Verdict verdict = Verdict::at_rest;
    double peak_rotation_ratio = 0, peak_slip_m = 0;
    /// Lowest amplitude at which the wave overturned the body, SI; for non_monotonic only, else NaN.
    double overturned_at = std::numeric_limits<double>::quiet_NaN();
};

/// Shares `most` among several that offer so many each: everyone gets one before anyone gets two, and so on; where
/// there are more of them than `most`, one each goes to as many evenly spread over them. \return what each gets
[[nodiscard]] std::vector<std::size_t> share_fairly(std::span<std::size_t const> offered, std::size_t most);

/// Stored columns of the trials, by their numbers; all of one length, which may be less than planned.
struct TrialColumns {
    std::span<Verdict const> verdicts;
    std::span<double const> peak_rotation_ratios, peak_slips_m;
};

/// By body, then kind; a kind of which a body has no trial is left out. Of trials that change back at most three, of
/// different waves: those farthest above the level at which their wave overturned the body. \pre the columns are of
/// this plan
[[nodiscard]] std::vector<TellingTrial> telling_trials(CampaignSpec const& spec, Plan const& plan,
                                                       TrialColumns const& columns);
/// The same of a results file.
[[nodiscard]] std::vector<TellingTrial> telling_trials(CampaignSpec const& spec, store::ResultsReader const& file);

}  // namespace overturn
