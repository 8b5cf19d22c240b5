/// Every trial with the intensity measures it can be judged by, kept while rows pass.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/intensity_measure.hpp"
#include "campaign/limit_state.hpp"
#include "campaign/rows.hpp"
#include "core/shared_draws.hpp"
#include "stats/criterion.hpp"
#include "stats/fragility_data.hpp"
#include "stats/response_bins.hpp"
#include "stats/two_measures.hpp"

namespace overturn {

/// The responses whose quantiles are reported level by level.
enum class LevelResponse { peak_slip, peak_rotation_ratio };

/// Outcome of a trial for one limit state.
struct TrialOutcome {
    std::int64_t wave = 0;
    std::int32_t body = 0;
    double amplitude = 0;
    bool decided = false, passed = false;
};

/// Largest number of trials held. In a larger campaign, curves over other measures than the levels' and all resampling
/// use the first waves alone.
inline constexpr std::size_t most_trials_held = 2'000'000;

/// Holds the first trials, whole waves of them, until there are two million: a campaign of any size is merged in
/// bounded memory and time, on each rank that fits curves of them. Each takes 80 bytes and 8 bytes for every measure
/// that does not scale with its wave.
class MeasuredTrials {
  public:
    /// \param measures those it holds, and no others
    /// \param shared waves that are no independent samples: they are resampled together
    explicit MeasuredTrials(std::vector<Measure> measures, SharedDraws shared = {});
    // Trials point to their waves, which a map keeps in place when it is moved, not when it is copied.
    MeasuredTrials(MeasuredTrials const&) = delete;
    MeasuredTrials& operator=(MeasuredTrials const&) = delete;
    MeasuredTrials(MeasuredTrials&&) = default;
    MeasuredTrials& operator=(MeasuredTrials&&) = default;
    ~MeasuredTrials() = default;

    /// \param measures one per body
    void add(WaveRow const& row, std::span<MeasureRow const> measures);
    /// Ignored if the trial's wave was not added before, or no more are held.
    void add(TrialRow const& row, LimitOutcomes const& limits);

    /// What is held of the bodies that are wanted, as pieces of some megabytes for `take` of another process of this
    /// program.
    void give(std::function<bool(std::int64_t)> const& wants, std::function<void(std::string)> const& piece) const;
    /// Holds the next piece of the same campaign.
    void take(std::string_view piece);

    /// The decided trials of a body with a measure above 0. \param limit place of the limit state; 0: overturning
    [[nodiscard]] std::vector<SingleTrial> singles(std::int64_t body, Measure measure, std::size_t limit = 0) const;
    /// The decided trials of a body with both measures above 0.
    [[nodiscard]] std::vector<TwoMeasureTrial> pairs(std::int64_t body, std::array<Measure, 2> const& measures,
                                                     std::size_t limit = 0) const;
    /// Every trial in turn, of all bodies: visit(TrialOutcome).
    template <class Visit> void each_outcome(std::size_t limit, Visit&& visit) const {
        for (auto const& trial : trials_) {
            visit(TrialOutcome{trial.wave(), trial.body, trial.amplitude, trial.limits.is_decided(limit),
                               trial.limits.has_passed(limit)});
        }
    }
    /// The trials of a body without a verdict on it, where their measure is known and above 0.
    [[nodiscard]] std::vector<SingleTrial> open(std::int64_t body, Measure measure, std::size_t limit = 0) const;
    /// Trials passed by because enough were held.
    [[nodiscard]] std::int64_t passed_by() const { return passed_by_; }
    /// Memory that so many trials are held in, without their waves [bytes].
    [[nodiscard]] static double bytes_of(std::int64_t trials, std::span<Measure const> measures);
    /// Trials of a body that `singles` leaves out, of those held.
    [[nodiscard]] std::int64_t left_out(std::int64_t body, Measure measure, std::size_t limit = 0) const;
    /// A response of the trials of a body, by the value of their level; NaN: unknown; infinite: of a rotation that
    /// ended in a fall.
    [[nodiscard]] std::map<double, std::vector<double>> by_level(std::int64_t body, LevelResponse response) const;
    /// Predictions of the criteria V_WES < V_Ereq and ouV_E < V_Ereq for the decided trials.
    [[nodiscard]] std::vector<CriterionTrial> criterion_trials(std::int64_t body, Measure measure) const;
    /// The decided trials of a body that moved: what it did with what it was offered.
    [[nodiscard]] std::vector<ResponseTrial> responses(std::int64_t body) const;

  private:
    using Waves = std::map<std::int64_t, std::vector<double>>;
    struct Measured {
        Waves::value_type const* of_wave;  ///< its wave, and the linear measures of it before scaling, body by body
        LimitOutcomes limits;
        std::int16_t body;
        bool decided, moved, slipped, uplifted;
        double peak_slip_m, peak_rotation_ratio;  ///< NaN: unknown; infinite: it fell
        double amplitude, scale, v_wes_mps, v_ereq_mps, v_resp_mps;

        [[nodiscard]] std::int64_t wave() const { return of_wave->first; }
        [[nodiscard]] bool overturned() const { return limits.has_passed(0); }
    };
    [[nodiscard]] std::int64_t together(std::int64_t wave) const { return shared_(wave); }

    /// Place of a measure's values: among the linear ones of a wave and body, or the others of a trial.
    struct Place {
        bool linear;
        std::size_t at;
    };
    [[nodiscard]] Place place_of(Measure measure) const;
    [[nodiscard]] double value(std::size_t trial, Place place) const;
    template <class Visit> void each_of(std::int64_t body, Visit&& visit) const {
        for (std::size_t t = 0; t < trials_.size(); ++t) {
            if (trials_[t].body == body) {
                visit(t, trials_[t]);
            }
        }
    }

    std::vector<Measure> linear_, others_;
    SharedDraws shared_;
    Waves waves_;  ///< linear measures of each wave, body by body
    std::int64_t passed_by_ = 0;
    std::deque<Measured> trials_;  ///< grows without a copy of itself
    std::deque<double> values_;    ///< other measures, trial by trial
};

}  // namespace overturn
