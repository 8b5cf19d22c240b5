/// Every trial with the intensity measures it can be judged by, kept while rows pass.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/limit_state.hpp"
#include "campaign/rows.hpp"
#include "stats/criterion.hpp"
#include "stats/fragility_data.hpp"
#include "stats/response_bins.hpp"
#include "stats/two_measures.hpp"

namespace overturn {

/// What a fragility can be drawn over.
enum class FragilityMeasure : std::int64_t {
    pga = 0,
    pgv = 1,
    v_wes = 2,
    ou_v_e = 3,
    v_wes_ratio = 4,
    level = 5,
    v_wes_other_unit = 6,  ///< R of T0 and T1 in the unit that the campaign does not name
    ou_v_e_other_unit = 7,
    sa_average = 8,
    sa_1 = 9,  ///< at the first of the campaign's periods, and so on up to most_sa_periods
};

/// Sa at the campaign's i-th period, from 0.
[[nodiscard]] constexpr FragilityMeasure sa_measure(std::size_t i) {
    return static_cast<FragilityMeasure>(static_cast<std::int64_t>(FragilityMeasure::sa_1)
                                         + static_cast<std::int64_t>(i));
}
/// Its place, of a measure that is one.
[[nodiscard]] constexpr std::optional<std::size_t> sa_place(FragilityMeasure measure) {
    return measure < FragilityMeasure::sa_1
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(measure) - static_cast<std::size_t>(FragilityMeasure::sa_1));
}

/// "pga", "pgv", "v_wes", "ou_v_e", "v_wes_ratio"; "level" for a level measure that is none of these (pgd, factor);
/// "v_wes_other_unit", "ou_v_e_other_unit"; "sa_average", "sa_1", "sa_2", ...
[[nodiscard]] std::vector<std::string> fragility_measure_names();

/// The measure itself, in whichever unit R was taken.
[[nodiscard]] constexpr FragilityMeasure in_any_unit(FragilityMeasure measure) {
    return measure == FragilityMeasure::v_wes_other_unit    ? FragilityMeasure::v_wes
           : measure == FragilityMeasure::ou_v_e_other_unit ? FragilityMeasure::ou_v_e
                                                            : measure;
}
[[nodiscard]] constexpr bool is_other_unit(FragilityMeasure measure) { return in_any_unit(measure) != measure; }

/// The responses whose quantiles are told level by level.
enum class LevelResponse { peak_slip, peak_rotation_ratio };

/// How a trial ended by one limit state.
struct TrialOutcome {
    std::int64_t wave = 0;
    std::int32_t body = 0;
    double amplitude = 0;
    bool decided = false, passed = false;
};

/// Holds the first trials, whole waves of them, until there are a million: what they say of a measure's curve is then
/// known to a fraction of a per cent, and a campaign of any size is merged in bounded memory and time.
class MeasuredTrials {
  public:
    /// \param waves_alike so many in a row are no independent samples: they are resampled together
    explicit MeasuredTrials(std::uint64_t waves_alike = 1) : waves_alike_(static_cast<std::int64_t>(waves_alike)) {}
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

    /// The decided trials of a body with a measure above 0. \param limit place of the limit state; 0: overturning
    [[nodiscard]] std::vector<SingleTrial> singles(std::int64_t body, FragilityMeasure measure,
                                                   std::size_t limit = 0) const;
    /// The decided trials of a body with both measures above 0.
    [[nodiscard]] std::vector<TwoMeasureTrial> pairs(std::int64_t body, std::array<FragilityMeasure, 2> const& measures,
                                                     std::size_t limit = 0) const;
    /// Every trial in turn, of all bodies: visit(TrialOutcome).
    template <class Visit> void each_outcome(std::size_t limit, Visit&& visit) const {
        for (auto const& trial : trials_) {
            visit(TrialOutcome{trial.wave, trial.body, trial.amplitude, trial.limits.is_decided(limit),
                               trial.limits.has_passed(limit)});
        }
    }
    /// The trials of a body without a verdict on it, where their measure is known and above 0.
    [[nodiscard]] std::vector<SingleTrial> open(std::int64_t body, FragilityMeasure measure,
                                                std::size_t limit = 0) const;
    /// Trials passed by because enough were held.
    [[nodiscard]] std::int64_t passed_by() const { return passed_by_; }
    /// Trials of a body that `singles` leaves out, of those held.
    [[nodiscard]] std::int64_t left_out(std::int64_t body, FragilityMeasure measure, std::size_t limit = 0) const;
    /// A response of the trials of a body, by the value of their level; NaN: unknown; infinite: of a rotation that
    /// ended in a fall.
    [[nodiscard]] std::map<double, std::vector<double>> by_level(std::int64_t body, LevelResponse response) const;
    /// As the criteria V_WES < V_Ereq and ouV_E < V_Ereq saw the decided trials.
    [[nodiscard]] std::vector<CriterionTrial> criterion_trials(std::int64_t body, FragilityMeasure measure) const;
    /// The decided trials of a body that moved: what it did with what it was offered.
    [[nodiscard]] std::vector<ResponseTrial> responses(std::int64_t body) const;

  private:
    struct OtherUnit {
        double v_wes_mps, ou_v_e_mps;
    };
    struct Peaks {
        double pga_mps2, pgv_mps, sa_average_mps2;
        std::array<double, most_sa_periods> sa_mps2;
        std::vector<OtherUnit> other_unit;  ///< one per body; empty where not asked for
    };
    struct Measured {
        std::int64_t wave;
        LimitOutcomes limits;
        std::int32_t body;
        bool decided, moved, slipped, uplifted;
        double peak_slip_m, peak_rotation_ratio;  ///< NaN: unknown; infinite: it fell
        double amplitude, scale, v_wes_mps, ou_v_e_mps, v_ereq_mps, v_resp_mps;
        Peaks const* peaks;  ///< of its wave before scaling: an entry of waves_

        [[nodiscard]] double value(FragilityMeasure measure) const;
        [[nodiscard]] bool overturned() const { return limits.has_passed(0); }
    };
    [[nodiscard]] std::int64_t together(std::int64_t wave) const { return wave / waves_alike_; }

    std::int64_t waves_alike_;
    std::map<std::int64_t, Peaks> waves_;
    std::int64_t passed_by_ = 0;
    std::vector<Measured> trials_;
};

}  // namespace overturn
