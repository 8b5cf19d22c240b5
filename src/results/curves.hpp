/// The fragility curves of a campaign, each of which a process can fit alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign_spec.hpp"
#include "core/bytes.hpp"
#include "results/statistics.hpp"
#include "stats/beta_split.hpp"
#include "stats/fragility.hpp"
#include "stats/intensity_unit.hpp"

namespace overturn {

/// A fit with what it is of.
struct MeasuredFragility {
    std::string limit = overturning_limit;  ///< name of the limit state
    Measure measure = measure_named("pga");
    std::string name;        ///< of the measure
    std::string label;       ///< the same, for people
    std::string title;       ///< the same, on axes of figures
    std::string units;       ///< of the measure, SI
    IntensityUnit shown_in;  ///< unit in print: the levels' where that measures the same
    std::string quote_base;  ///< base of quoted multiples: "design-basis", "v_ereq"; empty without quotes
    bool of_levels = true;   ///< over the levels' own measure: over others it depends on which levels were run
    FragilityFit fit;
    std::optional<BetaSplit> split;                               ///< where the bodies were drawn
    std::vector<std::string> drawn;                               ///< the quantities its scores are of
    double rank_area = std::numeric_limits<double>::quiet_NaN();  ///< NaN where all trials ended the same way
    Interval rank_interval{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};

/// Multiples of the design-basis level at which P is quoted.
inline constexpr std::array quoted_multiples{1.0, 1.5, 2.0, 3.0};

struct AnalysisOptions {
    double confidence = 0.95;
    std::optional<double> beta_u = {};  ///< beside what the bodies' scatter says; none: the campaign's
    int replicates = 1000;
    int band_points = 0;  ///< of the curve over the levels' own measure
};

/// Number of curves of a campaign: of each body, for each limit state, over each measure.
[[nodiscard]] std::int64_t count_curves(CampaignSpec const& spec);

/// Curves are numbered body by body, of a body limit state by limit state, of that measure by measure, the levels' own
/// first. \pre all that it is made of outlives it
class CampaignCurves {
  public:
    CampaignCurves(CampaignSpec const& spec, Statistics const& statistics, AnalysisOptions const& options);

    [[nodiscard]] Statistics const& statistics() const { return statistics_; }
    [[nodiscard]] AnalysisOptions const& options() const { return options_; }
    [[nodiscard]] std::int64_t count() const { return count_curves(spec_); }
    /// That a curve is of.
    [[nodiscard]] std::int64_t body_of(std::int64_t number) const;

    /// A curve with what it is of.
    [[nodiscard]] MeasuredFragility fit(std::int64_t number) const;
    /// The same for another process of this program: this one fits, that one takes what the fit gave.
    void give(std::int64_t number, BytesOut& bytes) const;
    [[nodiscard]] MeasuredFragility take(std::int64_t number, BytesIn& bytes) const;

    /// A body's curve over the levels' own measure, without a split by what was drawn.
    [[nodiscard]] FragilityFit over_levels(std::size_t body, std::size_t limit) const;

  private:
    struct Of {
        std::size_t body, limit;
        Measure measure;
        bool levels;  ///< over the levels' own measure
    };
    [[nodiscard]] Of of(std::int64_t number) const;
    [[nodiscard]] MeasuredFragility described(Of const& of) const;
    void add_quote_base(MeasuredFragility& curve) const;
    [[nodiscard]] FragilityFit over_levels(std::size_t body, std::size_t limit, std::vector<SingleTrial> trials,
                                           FragilityRequest request) const;
    [[nodiscard]] FragilityFit over_measure(Of const& of, std::vector<SingleTrial> trials,
                                            FragilityRequest request) const;
    [[nodiscard]] FragilityFit unfitted(std::size_t body, std::size_t limit) const;
    [[nodiscard]] bool shared() const;
    [[nodiscard]] double group_size() const { return spec_.source->about().shared.effect(); }
    [[nodiscard]] BootstrapKey bootstrap_of(std::size_t body) const { return {spec_.seed, body, options_.replicates}; }
    [[nodiscard]] FragilityRequest request_of(std::size_t body, std::size_t limit,
                                              std::optional<BetaSplit> const& split) const;

    CampaignSpec const& spec_;
    Statistics const& statistics_;
    AnalysisOptions const& options_;
    std::optional<FragilityState> no_sample_;
};

/// Fits all curves, in the order of their numbers. Several processes may share them: the numbers are the same.
using FitCurves = std::function<std::vector<MeasuredFragility>(CampaignCurves const& curves)>;

}  // namespace overturn
