/// The fragility of one body on one intensity measure: a curve where the data hold one, and what they hold otherwise.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stats/beta_split.hpp"
#include "stats/bootstrap.hpp"
#include "stats/goodness_of_fit.hpp"
#include "stats/isotonic.hpp"

namespace overturn {

/// Name for passing the limit state: a body overturns, a response exceeds its limit. "overturned" in the names of this
/// room stands for either.
enum class Passing : std::uint8_t { overturned, exceeded };

/// Remarks on a fit that a reader must know. Stored as bits: never renumber.
enum class FragilityFlag : std::uint32_t {
    no_trials = 0,
    nothing_overturned = 1,
    all_overturned = 2,
    one_level = 3,
    separated = 4,
    not_rising = 5,
    not_converged = 6,
    one_overturned = 7,
    two_levels = 8,
    non_monotone = 9,
    poor_fit = 10,
    median_outside_data = 11,
    hclpf_outside_data = 12,
    undecided_trials = 13,
    few_waves = 14,
    interval_unbounded = 15,
    waves_left_out = 16,
    no_beta_u = 17,              ///< nothing is known of what is not known: no HCLPF
    five_percent_doubtful = 18,  ///< the proportions contradict the curve where its 5 % point lies, or as a whole
};
inline constexpr std::uint32_t fragility_flags = 19;

using FragilityFlags = std::uint32_t;
[[nodiscard]] constexpr FragilityFlags bit(FragilityFlag flag) { return 1U << static_cast<std::uint32_t>(flag); }
[[nodiscard]] constexpr bool has(FragilityFlags flags, FragilityFlag flag) { return (flags & bit(flag)) != 0; }

/// Is it known which trials are of one wave?
enum class WavesKnown : std::uint8_t {
    yes,
    number_unknown,  ///< trials alone at their levels: not even how many waves there are
    no,              ///< all levels may have the same waves
};

/// The trials as stripes or one by one. With `trials` the bootstrap resamples their waves, without it every trial
/// counts as independent.
struct FragilityData {
    enum class Kind { stripes, singles };
    Kind kind = Kind::stripes;
    std::vector<FragilityPoint> points;
    std::vector<SingleTrial> trials;
    std::vector<SingleTrial> open;            ///< those without a verdict, where they were tried
    std::vector<FragilityPoint> open_points;  ///< the same counted: only `undecided` is not 0
    bool waves_shared = false;                ///< one wave, or waves that share a draw, have several trials
    bool waves_left_out = false;              ///< `trials` are the first of more than are held
    WavesKnown waves_known = WavesKnown::yes;
    std::int64_t fewest_waves = 0;  ///< where waves are not known: there are no fewer; 0: nothing is known of it

    [[nodiscard]] static FragilityData of_stripes(std::span<Stripe const> stripes);
    /// Single trials of a continuous measure. \param open those without a verdict; \param lost further ones, whose
    /// measure is not known \param group_size so many trials share what was drawn
    [[nodiscard]] static FragilityData of_trials(std::vector<SingleTrial> trials, bool waves_shared,
                                                 std::vector<SingleTrial> open = {}, std::int64_t lost = 0,
                                                 double group_size = 1);
};

/// An intensity at which P is wanted.
struct Quote {
    double intensity = 0;  ///< [SI]
    double multiple = 1;   ///< of the design basis
};

struct FragilityRequest {
    double confidence = 0.95;
    Passing passing = Passing::overturned;  ///< for words alone
    double beta_u = 0;  ///< stated: lognormal standard deviation of what is not known, beside what the trials hold
    /// Were the trials' bodies drawn from uncertain properties? The fitted beta is then sqrt(beta_R^2 + beta_U^2), and
    /// the split, where there is one, separates them.
    bool drawn = false;
    std::optional<BetaSplit> split;
    /// Are the draws' means no matter of chance (a Latin hypercube)? Resampling waves unbalances them, which is then no
    /// part of the median's error.
    bool draws_balanced = false;
    std::vector<Quote> quotes;
    std::vector<double> band_at;  ///< intensities at which the curve's band is wanted [SI]
    BootstrapKey bootstrap;
};

/// Bound on P from the trials at some intensities: for P there, and for P below or above them if it does not fall.
struct SeenBound {
    double from = 0, to = 0;           ///< intensities
    double units = 0, overturned = 0;  ///< trials; distinct waves where single trials share them; no units: none there
    Interval probability;
    double group_size = 1;  ///< so many units share what was drawn
    bool of_waves = false;  ///< units are distinct waves, or groups of those that share what was drawn
};

/// The nearest stripes (or tenths of the single trials) on either side of an intensity; outside all, on one.
struct Neighbours {
    SeenBound below, above;

    [[nodiscard]] Interval bounds() const { return {below.probability.lower, above.probability.upper}; }
    /// Did nothing overturn in both, or everything?
    [[nodiscard]] bool same_end() const {
        return below.overturned + above.overturned == 0
               || (below.overturned == below.units && above.overturned == above.units);
    }
};

/// P at one intensity.
struct QuotedProbability {
    Quote quote;
    std::optional<double> probability;  ///< of the curve; seen right there where that contradicts it, or it fits poorly
    std::optional<double> curve;        ///< of the curve, whatever it is worth there
    Interval bounds;                    ///< [0, 1] where nothing is known
    enum class Source { none, curve, stripe, neighbours };
    /// Source of the bounds: stripe where all trials there ended the same way, or no curve describes the data; likewise
    /// neighbours, where no stripe lies there but one on either side.
    Source source = Source::none;
    double trials = 0, overturned = 0;  ///< seen right there
    Interval seen;                      ///< their exact interval
    /// All stripes from there on in which nothing overturned, where they share no waves. P rises with the intensity, so
    /// that they bound it better than the trials right there alone.
    std::optional<SeenBound> pooled;
    /// Between two stripes: P, which rises with the intensity, lies from the lower end below to the upper end above.
    /// Elsewhere only where no curve describes the data.
    std::optional<Neighbours> neighbours;
    bool outside_data = false;  ///< below or above all intensities that were tried
    bool in_tail = false;       ///< P below a tenth of the lowest proportion that is not zero
    /// Bound from the nearest intensities from there on, where the curve's P lies below `least`, which no sample of
    /// that size can resolve. P rises with the intensity, so its upper end bounds P; there is no `probability` then.
    std::optional<SeenBound> bound;
    double least = 0;  ///< a tenth of one in the trials there, or at the nearest intensities from there on
};

/// The curve and its pointwise interval at one intensity.
struct BandPoint {
    double intensity = 0, probability = 0;
    Interval bounds;
};

/// The decided points with the undecided trials counted as fallen, or as standing.
[[nodiscard]] std::vector<FragilityPoint> with_undecided(FragilityData const& data, bool fallen);

struct FragilityFit {
    FragilityState state = FragilityState::no_trials;
    Passing passing = Passing::overturned;
    FragilityFlags flags = 0;
    double trials = 0, overturned = 0, undecided = 0;
    std::int64_t waves = 0;  ///< distinct, a group as one; the fewest where they are not known; 0: nothing is known
    WavesKnown waves_known = WavesKnown::yes;
    double group_size = 1;           ///< waves that share what was drawn
    double lowest = 0, highest = 0;  ///< intensities that were tried: the curve is drawn solid between them
    double lowest_proportion = 0;    ///< of the lowest stripe (or tenth of the trials) in which anything overturned

    std::optional<ProbitLine> line;  ///< empty where not identifiable
    struct Intervals {
        Interval median, beta, five_percent_point;
        std::optional<Interval> hclpf;  ///< nothing without a beta_U
    };
    /// Of the decided trials. No bootstrap of trials alone at their levels, without waves: it would scatter with
    /// nothing.
    std::optional<Intervals> profile, bootstrap;
    std::optional<Intervals> ends;  ///< to be signed: of `method`, with undecided trials as either extreme
    /// Trials that share waves are resampled with them. Of few waves that gives short intervals: the profile
    /// likelihood, and so many exact capacities, widen them; likewise where the waves are not known.
    enum class Method { profile_likelihood, bootstrap_by_waves, widest };
    Method method = Method::profile_likelihood;
    std::size_t replicates = 0, replicates_without_curve = 0;
    std::vector<Replicate> refits;  ///< of the bootstrap, for what is computed from the curve
    /// Refits with the undecided trials all standing and all fallen: an empty list where that holds no curve; none
    /// without any.
    std::vector<std::vector<Replicate>> extreme_refits;

    std::optional<GoodnessOfFit> goodness;
    MonotoneTest monotone;
    std::vector<PooledPoints> isotonic;
    Interval isotonic_median;
    std::optional<ProbitLine> penalised;  ///< Firth's fit of separated data
    std::optional<SeenBound> bound;       ///< nothing, or everything, overturned; or all that did lies at one end
    std::optional<SeenBound> pooled;  ///< of several stripes together: its upper end at `from`, its lower one at `to`
    bool beta_u_known = false;        ///< stated, or drawn and significantly above 0
    double beta_u = 0;                ///< drawn and stated together
    double beta_u_drawn = 0;          ///< the part of it that the fitted beta holds
    double beta_u_stated = 0;         ///< the part of it that stands beside the trials
    bool drawn = false;               ///< were the trials' bodies drawn from uncertain properties?
    /// Stripes on either side of the 5 % point, where the proportions contradict the curve about it.
    std::optional<Neighbours> beside_five_percent;
    std::vector<QuotedProbability> quotes;
    std::vector<BandPoint> band;

    [[nodiscard]] bool identifiable() const { return line.has_value(); }
    /// Part of beta from waves alone.
    [[nodiscard]] double beta_r() const;
    /// Intensity at which the curve, with all that was drawn, reaches 5 %: exp(ln median - 1.645 beta). Nothing without
    /// a curve.
    [[nodiscard]] std::optional<double> five_percent_point() const;
    /// exp(ln median - 1.645 (beta_R + beta_U)): high confidence, low probability of failure (EPRI TR-103959). Nothing
    /// where beta_U is not known, or the trials do not limit it from below.
    [[nodiscard]] std::optional<double> hclpf() const;
    /// Intensity at which the composite curve, with beta_R and beta_U together, reaches 1 %; nothing where HCLPF is not
    /// known.
    [[nodiscard]] std::optional<double> one_percent_point() const;
    /// Median of the curve that is believed with this confidence to lie at or right of the true one; its beta is
    /// beta_r(): exp(ln median - beta_U Phi^-1(confidence)). Nothing where beta_U is not known.
    [[nodiscard]] std::optional<double> median_at(double confidence) const;
    /// The intervals to be signed.
    [[nodiscard]] Intervals const& intervals() const { return *ends; }
};

/// Confidences of the curves that are reported.
inline constexpr std::array reported_confidences{0.05, 0.5, 0.95};

[[nodiscard]] FragilityFit fit_fragility(FragilityData const& data, FragilityRequest const& request);

}  // namespace overturn
