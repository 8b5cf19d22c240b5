/// A work-precision study of a campaign: error against time for every knob, and what the number of waves does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cost/comparison.hpp"
#include "cost/knob.hpp"
#include "cost/pareto.hpp"
#include "cost/rare_cost.hpp"
#include "cost/sampling.hpp"
#include "cost/step_error.hpp"

namespace overturn::cost {

/// One setting's place on its knob's map.
struct Measured {
    Setting setting;
    double seconds = 0;  ///< CPU per trial or wave, the best of a few rounds
    Spread error;        ///< of the kind in Knob::error
    /// Verdicts against the reference: trials, flips, P(overturn), distribution; nothing for knobs without verdicts.
    std::int64_t trials = 0, flips = 0, overturning_flips = 0;
    double probability_error = not_known;
    double ks = not_known;
    bool here = false;  ///< where the campaign stands
    bool on_front = false;
};

struct KnobResult {
    Knob knob;
    std::vector<Measured> rows;
    std::int64_t units = 0;  ///< trials or waves behind every row
    double floor = 0;        ///< errors up to here are what rounding does, and all the same
    std::string advice;      ///< the campaign's setting, and the gain of the next step
};

struct Study {
    std::string title;
    std::int64_t waves = 0, trials = 0;                    ///< of the sample
    std::int64_t campaign_waves = 0, campaign_trials = 0;  ///< of the campaign
    double confidence = 0;
    double reference_seconds = 0;  ///< CPU per trial of the reference
    Comparison defaults;           ///< the campaign as it stands against the reference
    Comparison rounding;           ///< a second reference against the first: what nothing can resolve
    StepError step_error;          ///< of every quantity of limits
    std::vector<KnobResult> knobs;
    Sampling sampling;
    std::optional<RareCost> rare;  ///< where the campaign has rare events
    Balance balance;
    std::string sentence;     ///< whether the accuracy suffices
    std::string effect;       ///< which setting matters most, and by how much
    bool continuous = false;  ///< some base presses all along, without points
    bool is_grid = false;     ///< its waves are a grid and no sample: no results on sampling
};

struct StudyOptions {
    std::int64_t waves = 0;  ///< of the sample; 0: as many as fit into `seconds`, but a few at least
    double seconds = 60;     ///< wanted wall time
    double timing_s = 0.03;  ///< a setting that takes less CPU time is run again until it has had as much, twice
};

/// Receives after every step the share of the work that is done, and the seconds that are probably left.
using Tell = std::function<void(double done, double left_s)>;

/// Everything but the times is a pure function of the campaign and the number of waves. \throws InputError
[[nodiscard]] Study run_study(CampaignInput const& input, StudyOptions const& options, Tell const& tell);

/// Times and errors that differ by no more than this share are taken as equal.
inline constexpr double noise = 0.15;

/// A row as a point of its knob's map: time against the 95 % quantile of the error, at least `floor`.
[[nodiscard]] Point point_of(Measured const& row, double floor);

/// "Largest effect of a setting: effects = none changes 12 of 48 verdicts; the campaign's auto changes 0." The values
/// tried are compared with the reference, knobs without verdicts left out.
[[nodiscard]] std::string largest_effect(std::vector<KnobResult> const& knobs);

/// "order 8 x 1 is on the front. Faster: order 6 x 1, 1.2 times, flips 0 of 960 verdicts, ..."
[[nodiscard]] std::string advice_of(KnobResult const& result);

}  // namespace overturn::cost
