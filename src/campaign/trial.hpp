/// make the wave -> measure it -> respond -> one row. Everything here is a pure function of the campaign and a number.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "campaign/known_trials.hpp"
#include "campaign/plan.hpp"
#include "campaign/rows.hpp"
#include "motion/intensity.hpp"
#include "response/registry.hpp"

namespace overturn {

/// Seconds spent per phase; for the reader, never for the results.
struct PhaseSeconds {
    double waves = 0, measures = 0, response = 0, store = 0;
    std::vector<ModelCost> models = std::vector<ModelCost>(overturn::model_categories().size());  ///< in their order

    void add(PhaseSeconds const& more);
};

/// A wave with everything that is computed once for it.
struct PreparedWave {
    std::int64_t number = 0;
    bool tried = true;  ///< is_tried: else there is nothing to respond to
    GroundMotion motion;
    Intensity intensity;
    WaveRow row;
    std::vector<MeasureRow> measures;  ///< one per body
    std::vector<DrawnBody> bodies;     ///< as they are under this wave
    ChunkExtremes chunks;
};

/// Makes and measures a wave. A wave that cannot be made is a failed one, not an exception.
[[nodiscard]] PreparedWave prepare_wave(CampaignSpec const& spec, Plan const& plan, std::int64_t wave,
                                        PhaseSeconds& seconds);

/// Does the wave count, by the rule that waves are held to? What could not be made meets none.
[[nodiscard]] bool is_tried(Acceptance const& acceptance, WaveRow const& row);

/// One trial on a prepared wave. \param observer sees the history if given, with its way through the room where there
/// is a site (SitePath)
[[nodiscard]] TrialRows run_trial(CampaignSpec const& spec, PreparedWave const& wave, std::int64_t body,
                                  std::int64_t level, Observer* observer = nullptr);

/// All trials of prepared waves, side by side, appended in order: each is bit-equal to run_trial's.
/// \param keep_running called now and then, and before every trial on points \return false if it returned false: then
/// `trials` is of no use \param known trials that are not computed again, or null
bool append_trials(
    CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves, TrialRows& trials,
    PhaseSeconds& seconds, std::function<bool()> const& keep_running = [] { return true; },
    KnownTrials const* known = nullptr);

/// Number of waves whose trials run side by side: enough to fill the vector lanes, few enough to hold in memory.
[[nodiscard]] std::int64_t waves_together(Plan const& plan);

}  // namespace overturn
