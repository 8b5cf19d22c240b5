/// Counts over the rows of a campaign: verdicts, limit states, criteria, waves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/block_rows.hpp"
#include "campaign/campaign_spec.hpp"
#include "results/achieved_sigma.hpp"
#include "results/grid_map.hpp"
#include "results/measured_trials.hpp"
#include "results/missed_clauses.hpp"
#include "stats/stripe.hpp"

namespace overturn {

/// Counts of one body for a limit state of the user's own. `overturned` of its stripes stands for passed.
struct LimitStatistics {
    std::vector<Stripe> stripes;
    std::int64_t unknown = 0;      ///< trials with a verdict that leave it open: no model gave its quantity
    std::int64_t fell_within = 0;  ///< trials that fell over and kept within it
};

/// One body's stripes, and how each criterion did per level.
struct BodyStatistics {
    std::string body;
    std::vector<Stripe> stripes;          ///< of overturning
    std::vector<LimitStatistics> limits;  ///< of the campaign's others, in its order from place 1
    std::vector<Confusion> v_wes, ou_v_e;
    std::vector<std::vector<std::int64_t>> ends;      ///< trials per verdict, in the order of verdicts(), and level
    std::vector<std::vector<std::int64_t>> required;  ///< trials per effect, in the order of effects(), and level
    std::vector<std::int64_t> left_out;  ///< trials per effect that no model holds beside the others required
    /// Trials per level that still rocked when the record ended: they fell, or rose to their peak, only after it. Those
    /// that rocked on below an earlier peak are not known from rows.
    std::vector<std::int64_t> fell_after_record, peaked_after_record;
    std::vector<std::int64_t> models;  ///< trials per model, in the order of model_categories()
    std::vector<GridLine> grid;        ///< one per wave where waves are points of a grid; else none

    /// \param limit place of the limit state; 0: overturning
    [[nodiscard]] std::vector<Stripe> const& stripes_of(std::size_t limit) const {
        return limit == 0 ? stripes : limits.at(limit - 1).stripes;
    }
};

/// Counts of the waves: made, failed, accepted, refused.
struct WaveCounts {
    std::int64_t waves = 0, failed = 0;
    std::int64_t not_accepted = 0;  ///< of `waves`, which miss the rule: in files up to format 4, or used all the same
    std::int64_t refused = 0;       ///< drawn beside them and no trials, since they miss the rule
    /// Iterated to a target and short of match_tolerance, without a rule that would refuse them.
    std::int64_t missed = 0;

    void add(WaveRow const& row);
};

/// Are trials held one by one, as curves need them, or only counted?
enum class TrialsHeld : std::uint8_t { all, none };

/// Counts trials as they come; integers only, so that no order can matter. Keeps the measured ones for the curves.
/// Waves come in their order.
class Statistics {
  public:
    /// \param spec outlives it
    explicit Statistics(CampaignSpec const& spec, TrialsHeld held = TrialsHeld::all);
    /// \param own what models have to say of their own about it; empty: not at hand
    void add(TrialRow const& row, std::span<std::byte const> extra = {});
    /// A wave that a rule refused.
    void add_refused(WaveRow const& row);
    /// \param measures one per body
    void add(WaveRow const& row, std::span<MeasureRow const> measures);
    void add(BlockRows const& block);
    /// Can counts be added up that were made of parts of the rows? Not where more than counts is taken from waves, one
    /// by one in their order: of drawn targets, of a rule for waves, of a grid.
    [[nodiscard]] static bool add_up(CampaignSpec const& spec);
    /// All counts, in an order that the campaign decides. Curves need these and the held trials, and nothing that does
    /// not add up.
    [[nodiscard]] std::vector<std::int64_t> counts() const;
    /// Adds counts() of another part of the rows.
    void add_counts(std::span<std::int64_t const> counts);
    /// Holds trials that another process gave (MeasuredTrials::take), and counts none.
    void take_trials(std::string_view piece) { measured_.take(piece); }
    [[nodiscard]] std::vector<BodyStatistics> const& bodies() const { return bodies_; }
    [[nodiscard]] WaveCounts const& waves() const { return waves_; }
    /// Clauses missed by refused waves, or by used ones that miss the rule.
    [[nodiscard]] MissedClauses const& missed_clauses() const { return missed_clauses_; }
    /// Scatter of the waves, where targets are drawn.
    [[nodiscard]] std::optional<AchievedSigma> achieved_sigma() const { return sigma_.achieved(waves_.missed); }
    /// Do limit states depend on extra quantities of models?
    [[nodiscard]] bool reads_extra() const { return judge_.reads_extra(); }
    /// Trials whose waves were added too; none where none are held.
    [[nodiscard]] MeasuredTrials const& measured() const { return measured_; }

  private:
    template <class Self, class Visit> static void each_count(Self& self, Visit&& visit);
    LimitJudge judge_;
    TrialsHeld held_;
    void count_after_record(TrialRow const& row, BodyStatistics& body) const;

    WaveCounts waves_;
    MissedClauses missed_clauses_;
    SigmaCount sigma_;
    MeasuredTrials measured_;
    double duration_s_ = never;                       ///< of the first wave
    std::map<std::int64_t, double> other_durations_;  ///< of waves unlike it, by id
    std::vector<BodyStatistics> bodies_;
};

/// Memory that Statistics take for so many trials, of which `most_trials_held` are held one by one [bytes].
[[nodiscard]] double memory_of_trials(CampaignSpec const& spec, std::int64_t trials);

}  // namespace overturn
