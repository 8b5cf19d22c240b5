/// Analysis of a campaign's trials: fragility curves over several measures, and the quality of the energy criterion.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "results/curves.hpp"
#include "results/grid_map.hpp"
#include "results/measured_trials.hpp"
#include "results/statistics.hpp"
#include "stats/quantile.hpp"

namespace overturn {

/// One criterion of one body, measure < V_Ereq.
struct MeasuredCriterion {
    Measure measure = measure_named("v_wes");
    RadiusUnit radius_unit = RadiusUnit::centimetre;  ///< unit of R in T0 and T1
    CriterionStudy study;
};

/// Evidence on whether safe means safe, from the trials that V_WES < V_Ereq predicts to be safe.
enum class Safety : std::uint8_t {
    none_predicted_safe,
    none_uplifted,       ///< they were never in danger
    false_safe,          ///< some overturned
    nothing_overturned,  ///< neither they nor any other
    few_waves,           ///< none of them overturned, in fewer waves than would show it
    conservative,
};

/// Does a finding speak for the criterion or against it?
enum class Speaks : std::uint8_t { in_favour, against, neither };

/// V_WES beside another measure of the same waves.
struct MeasureBeside {
    std::size_t curve = 0;                    ///< the other's place in BodyAnalysis::fragility
    std::optional<Interval> beta_ratio = {};  ///< of V_WES over the other's, the same resampled waves for both
    std::optional<Speaks> dispersion = {};    ///< by that ratio; none where one of them has no curve
    std::optional<Speaks> rank = {};          ///< none where all trials ended the same way
};

/// Findings of the trials on the paper's claim that V_WES is practical and conservative.
struct CriterionVerdict {
    Safety safety = Safety::none_predicted_safe;
    Speaks false_alarms = Speaks::neither;  ///< are they fewer than half of the alarms?
    std::vector<MeasureBeside> beside;      ///< none where all waves have one spectrum
};

/// The fragility of one body by a limit state of the user's own.
struct LimitAnalysis {
    std::string name, definition;
    std::vector<MeasuredFragility> fragility;  ///< as BodyAnalysis::fragility
};

/// A response of a body at one level: median, 84 % and 95 % of it.
struct LevelQuantiles {
    std::string quantity;  ///< "peak_slip"
    std::string units;
    std::size_t level = 0;
    double amplitude = 0;
    std::int64_t trials = 0, unknown = 0;  ///< with a known value, those that fell among them; and others
    std::int64_t overturned = 0;           ///< of the known ones: above every other value
    double fallen = 0;                     ///< value for a body that fell
    /// Lowest and highest of the known ones, those that fell as `fallen`; NaN: none is known.
    double least = std::numeric_limits<double>::quiet_NaN(), most = least;
    std::array<SampleQuantile, 3> quantiles;  ///< value NaN: too few independent ones for it
};

struct BodyAnalysis {
    std::string body;
    std::string variability;                   ///< cause of the waves' differences, on which every spread below depends
    std::optional<AchievedSigma> sigma;        ///< their scatter, where targets are drawn
    bool one_spectrum = false;                 ///< of all waves: no measure can prove better than another
    std::vector<MeasuredFragility> fragility;  ///< of overturning
    std::vector<LimitAnalysis> limits;
    std::vector<LevelQuantiles>
        quantiles;  ///< of peak slip (unless it cannot slip) and rotation, level by level; of a sample
    std::vector<MeasuredCriterion> criterion;
    std::vector<ResponseBin> response;        ///< V_resp over V_WES
    std::optional<CriterionVerdict> verdict;  ///< none without energies, and of waves that are no sample (no_sample)
    /// Map of the grid, where waves are a grid: it replaces curves and quantiles. Fits are then all of state `grid`; of
    /// the criterion there are only counts, of the response nothing.
    std::optional<GridMap> grid;

    /// The curves of the limit state of that place in the campaign; 0: overturning.
    [[nodiscard]] std::vector<MeasuredFragility> const& curves_of(std::size_t limit) const {
        return limit == 0 ? fragility : limits.at(limit - 1).fragility;
    }
    /// The fit over the levels' own measure.
    [[nodiscard]] MeasuredFragility const& over_levels() const { return fragility.front(); }
};

/// \param fit who fits the curves; empty: this process alone
[[nodiscard]] std::vector<BodyAnalysis> analyse(CampaignSpec const& spec, Statistics const& statistics,
                                                AnalysisOptions const& options, FitCurves const& fit = {});

/// Prints measures that are velocities in this unit; none: leaves them in the levels' own, or m/s.
void tell_velocities(std::vector<BodyAnalysis>& bodies, std::optional<IntensityUnit> const& unit);

/// One body's fit over the levels' own measure, alone. \param limit place of the limit state; 0: overturning
[[nodiscard]] FragilityFit fit_over_levels(CampaignSpec const& spec, Statistics const& statistics, std::size_t body,
                                           AnalysisOptions const& options, std::size_t limit = 0);

}  // namespace overturn
