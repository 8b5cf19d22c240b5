/// Runs one setting on a sample of the campaign's waves and times it as a campaign would spend the time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "campaign/trial.hpp"
#include "cost/knob.hpp"

namespace overturn::cost {

/// CPU time of this thread [s]: other programs on the machine do not count.
[[nodiscard]] double thread_cpu_seconds();

/// `count` numbers of 0 .. of-1 at even distances, rising.
[[nodiscard]] std::vector<std::int64_t> spread_over(std::int64_t count, std::int64_t of);

/// Some waves of a campaign, made and measured as the campaign says.
struct Sample {
    CampaignSpec const& spec;
    Plan const& plan;
    std::vector<PreparedWave> waves;
};

/// Results and time of one setting.
struct Run {
    double seconds = 0;          ///< CPU, all of it
    std::int64_t units = 0;      ///< trials or waves that it was for
    std::vector<TrialRow> rows;  ///< where trials were run
    std::vector<double> values;  ///< where something else was measured: see bench.cpp
};

/// All trials of a campaign on waves that are at hand, together as run_block has them.
[[nodiscard]] TrialRows all_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves);

/// The same, timed.
[[nodiscard]] Run run_trials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves);

/// values: the measure per wave and body [m/s]. \param acts ou_v_e or v_wes
[[nodiscard]] Run run_energy(Sample const& sample, double panel_phase_rad, Acts acts);

/// Whether a run is looked at or only timed.
enum class Depth { whole, times };

/// Makes the sample's waves anew as `variant` says. values: mean misfit per wave to the target of `input`; rows: the
/// trials on those waves, which are not timed; neither at Depth::times.
[[nodiscard]] Run run_matching(Sample const& sample, CampaignInput const& input, CampaignSpec const& variant,
                               Depth depth);

/// Spectra of the sample's waves. values: per wave, ordinates at the periods of the reference, read between the
/// computed ones along straight lines of the logarithms.
[[nodiscard]] Run run_spectra(Sample const& sample, double per_decade, Depth depth);

}  // namespace overturn::cost
