#include "results/hazard_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "motion/column_unit.hpp"
#include "motion/pair_table.hpp"
#include "motion/text_lines.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

// The unit that the first column's name states, none of a pure number; the name itself has to be the levels' measure,
// and the second column's the mean number of exceedances in a year.
IntensityUnit unit_of(PairTable const& table, LevelSpec const& levels, Location const& where) {
    auto const measure = levels.measure_label();
    auto const name = lowered(table.first_name);
    auto const behind = name.substr(std::min(measure.size(), name.size()));
    if (!name.starts_with(measure)
        || (!behind.empty() && std::string_view(" _\t([").find(behind[0]) == std::string::npos)) {
        throw InputError(where, fmt::format("hazard over '{}' (the levels are {}). State it over {}", table.first_name,
                                            measure, measure));
    }
    auto const frequency = lowered(table.second_name);
    if (frequency != "annual_exceedance" && frequency != "annual_exceedance [1/a]"
        && frequency != "annual_exceedance (1/a)") {
        throw InputError(
            where, fmt::format("'{}' (must be annual_exceedance [1/a]: exceedances in a year; of a return period its "
                               "inverse, of a probability in t years -ln(1 - p) / t). Convert it",
                               table.second_name));
    }
    auto const dimension = levels.dimension();
    if (dimension == Dimension::none) {
        return {};
    }
    auto const column = "a" + behind;
    auto const unit = unit_of_values(column, dimension);
    if (!unit) {
        throw InputError(
            where, fmt::format("'{}' states no unit of {} (one of {}). Write for example '{} [{}]'", table.first_name,
                               name_of(dimension), accepted_units(dimension), measure, si_symbol(dimension)));
    }
    return {std::string(unit_text_in_name(column).text), *unit};
}

std::string intensity_text(double intensity, HazardCurve const& hazard, LevelSpec const& levels) {
    auto const& stated = hazard.stated();
    return stated.symbol.empty() ? levels.text(intensity)
                                 : fmt::format("{:.6g} {}", stated.of(intensity), stated.symbol);
}

double whole(AnnualFrequency const& frequency) { return frequency.annual + frequency.beyond_least; }

LognormalFragility curve_of(Replicate const& refit, double beside) {
    return {std::exp(refit.log_median), std::hypot(refit.beta, beside)};
}

// Refits without a curve bound nothing: neither how often it is passed nor how seldom.
Interval interval_of(std::span<Replicate const> refits, double beside, HazardCurve const& hazard, double confidence) {
    std::vector<double> frequencies;
    double const all = hazard.points().front().annual_exceedance;
    std::size_t open = 0;
    for (auto const& refit : refits) {
        if (std::isnan(refit.log_median) || std::isnan(refit.beta)) {
            ++open;
        } else {
            frequencies.push_back(whole(annual_frequency(hazard, curve_of(refit, beside))));
        }
    }
    auto low = frequencies;
    auto high = frequencies;
    low.insert(low.end(), open, 0.0);
    high.insert(high.end(), open, all);
    return {middle_of(low, confidence, {0, all}).lower, middle_of(high, confidence, {0, all}).upper};
}

// Whatever trials without a verdict would have done.
Interval interval_of_mean(FragilityFit const& fit, HazardCurve const& hazard, double confidence) {
    // What was drawn is in the refits; what was stated stands beside.
    double const beside = std::sqrt(std::max(0.0, fit.beta_u * fit.beta_u - fit.beta_u_drawn * fit.beta_u_drawn));
    auto ends = interval_of(fit.refits, beside, hazard, confidence);
    for (auto const& refits : fit.extreme_refits) {
        ends = hull(ends, refits.empty() ? Interval{0, hazard.points().front().annual_exceedance}
                                         : interval_of(refits, beside, hazard, confidence));
    }
    return ends;
}

// Has any wave a component beside the horizontal one? Waves that are drawn are alike in that.
bool has_further_components(CampaignSpec const& spec) {
    auto const waves = spec.source->available() ? static_cast<std::uint64_t>(spec.wave_count) : 1;
    for (std::uint64_t wave = 0; wave < waves; ++wave) {
        auto const motion = spec.source->make_unjudged(spec.seed, wave).motion;
        if (!motion.transverse_mps2.empty() || !motion.vertical_mps2.empty()) {
            return true;
        }
    }
    return false;
}

// A rigid body on its two corners moves under no peak acceleration up to that of uplift, or of slip. Elsewhere, under
// further components, on a base that gives way, of a body that scatters or leans, no level is known to be too weak.
double nothing_below(CampaignSpec const& spec, BodySpec const& body) {
    bool const rigid = !body.footing.stated && body.scattering().empty() && body.body.initial_tilt_rad() == 0;
    if (spec.levels.measure != LevelMeasure::pga || !rigid || has_further_components(spec)) {
        return 0;
    }
    double const slips = body.friction ? body.body.gravity_mps2() * body.friction->static_coefficient
                                       : std::numeric_limits<double>::infinity();
    return std::min(body.body.uplift_acceleration_mps2(), slips);
}

BodyFrequency frequency_of(FragilityFit const& fit, FragilityData const& stripes, HazardCurve const& hazard,
                           double confidence, double nothing) {
    BodyFrequency made;
    made.nothing_below = nothing;
    auto const seen = [&](double none_up_to) {
        return hull(annual_frequency_seen(hazard, with_undecided(stripes, false), confidence, none_up_to),
                    annual_frequency_seen(hazard, with_undecided(stripes, true), confidence, none_up_to));
    };
    made.seen = seen(nothing);
    made.seen_below_levels = made.seen.upper - seen(std::max(nothing, fit.lowest)).upper;
    if (!fit.identifiable()) {
        return made;
    }
    double const median = std::exp(fit.line->log_median());
    LognormalFragility const composite{median, std::hypot(fit.beta_r(), fit.beta_u)};
    made.mean = annual_frequency(hazard, composite);
    made.interval = interval_of_mean(fit, hazard, confidence);
    made.few_waves = has(fit.flags, FragilityFlag::few_waves) ? fit.waves : 0;
    made.poor = has(fit.flags, FragilityFlag::poor_fit) || has(fit.flags, FragilityFlag::no_five_percent_point);
    if (made.poor || fit.undecided > 0) {  // with all of them fallen, or standing, it may not describe the data
        made.interval = hull(made.interval, made.seen);
    }
    if (made.mean->annual > 0) {
        made.shares = shares_of(hazard, composite, fit.lowest, fit.highest);
    }
    if (fit.beta_u > 0) {
        constexpr double score = 1.6448536269514722;
        auto const at = [&](double scores) {
            return whole(annual_frequency(hazard, {median * std::exp(scores * fit.beta_u), fit.beta_r()}));
        };
        made.fractiles = {at(score), at(0), at(-score)};
    }
    return made;
}

}  // namespace

HazardCurve parse_hazard(std::string_view content, std::string const& name, LevelSpec const& levels) {
    auto const table =
        read_pair_table(content, name, "intensity and annual exceedance", [](Pair const& point, Pair const* before) {
            (void)HazardCurve({before != nullptr ? HazardPoint{before->first, before->second}
                                                 : HazardPoint{point.first / 2, point.second * 2},
                               {point.first, point.second}});
        });
    Location const where{name, table.names_line};
    if (table.names_line == 0) {
        throw InputError(Location{name, 1}, fmt::format("no line of names (what is exceeded, in which unit?). Begin "
                                                        "with '{} [{}], annual_exceedance'",
                                                        levels.measure_name(), levels.shown_units()));
    }
    auto unit = unit_of(table, levels, where);
    std::vector<HazardPoint> points;
    for (auto const& [intensity, annual] : table.points) {
        points.push_back({intensity * unit.si, annual});
    }
    if (points.size() < 2) {
        throw InputError(where, fmt::format("hazard curve of {} point{} (at least two). Add some", points.size(),
                                            points.size() == 1 ? "" : "s"));
    }
    return HazardCurve(std::move(points), std::move(unit));
}

std::vector<BodyFrequency> frequencies_of(CampaignSpec const& spec, Statistics const& statistics,
                                          std::vector<BodyAnalysis> const& analysis, HazardCurve const& hazard,
                                          double confidence) {
    std::vector<BodyFrequency> all;
    for (std::size_t b = 0; b < analysis.size(); ++b) {
        double const nothing = nothing_below(spec, spec.bodies[b]);
        for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
            auto const& fits = limit == 0 ? analysis[b].fragility : analysis[b].limits[limit - 1].fragility;
            auto const stripes = FragilityData::of_stripes(statistics.bodies()[b].stripes_of(limit));
            all.push_back(frequency_of(fits.front().fit, stripes, hazard, confidence, nothing));
            all.back().body = analysis[b].body;
            all.back().limit = spec.limits[limit].name;
        }
    }
    return all;
}

std::string frequency_table(CampaignSpec const& spec, std::vector<BodyFrequency> const& frequencies,
                            HazardCurve const& hazard, double confidence) {
    auto text = fmt::format(
        "\nannual frequency, by a hazard curve of {} points from {} ({:.3g} 1/a) to {} ({:.3g} 1/a)\n"
        "{:>24} {:>11} {:>24} {:>30} {:>24}\n",
        hazard.points().size(), intensity_text(hazard.first(), hazard, spec.levels),
        hazard.points().front().annual_exceedance, intensity_text(hazard.last(), hazard, spec.levels),
        hazard.points().back().annual_exceedance, "body, limit state", "mean 1/a",
        fmt::format("{:g} %", 100 * confidence), "confidence 5, 50, 95 %", "stripes alone");
    constexpr double much = 0.05;
    constexpr double nearly_all = 0.75;
    for (auto const& f : frequencies) {
        auto const name = f.limit == overturning_limit ? f.body : fmt::format("{}, {}", f.body, f.limit);
        auto const seen = fmt::format("[{:.3g}, {:.3g}]", f.seen.lower, f.seen.upper);
        if (!f.mean) {
            text += fmt::format("{:>24} {:>11} {:>24} {:>30} {:>24}\n", name, "-", "no curve", "-", seen);
            continue;
        }
        text += fmt::format("{:>24} {:>11.3g} {:>24} {:>30} {:>24}\n", name, whole(*f.mean),
                            fmt::format("[{:.3g}, {:.3g}]", f.interval.lower, f.interval.upper),
                            f.fractiles ? fmt::format("{:.3g}, {:.3g}, {:.3g}", f.fractiles->low, f.fractiles->median,
                                                      f.fractiles->high)
                                        : std::string("beta_U unknown"),
                            seen);
        if (f.shares) {
            text +=
                fmt::format("    of it {:.1f} % by motions below the levels tried, {:.1f} % between, {:.1f} % above\n",
                            100 * f.shares->below, 100 * f.shares->between, 100 * f.shares->above);
            if (f.shares->below + f.shares->above > much) {
                text += fmt::format(
                    "  note: {}: {:.0f} % of the frequency rests on the curve outside the levels that "
                    "were tried. State levels there\n",
                    name, 100 * (f.shares->below + f.shares->above));
            }
        }
        if (f.mean->beyond_most > much * whole(*f.mean)) {
            text += fmt::format(
                "  note: {}: motions beyond the hazard curve's last point add {:.3g} to {:.3g} 1/a, of "
                "which the lower end is counted. State the curve further\n",
                name, f.mean->beyond_least, f.mean->beyond_most);
        }
        if (f.mean->at_first > 0.01) {
            text += fmt::format(
                "  note: {}: P is {:.2g} at the hazard curve's first point: weaker motions, of which it "
                "says nothing, are left out. State the curve from lower on\n",
                name, f.mean->at_first);
        }
        if (f.seen_below_levels > nearly_all * f.seen.upper) {
            text += fmt::format(
                "  note: {}: {:.2g} of the {:.2g} 1/a that the stripes alone allow is by motions weaker than all "
                "levels, of "
                "which they say no more than of the lowest. State lower levels, or the hazard curve from there on\n",
                name, f.seen_below_levels, f.seen.upper);
        }
        if (f.few_waves > 0) {
            text += fmt::format(
                "  note: {}: the curve's interval comes from resampling {} independent waves, or groups of "
                "them, and is too short\n",
                name, f.few_waves);
        }
        if (f.poor) {
            text += fmt::format(
                "  note: {}: comes from a curve that does not describe the data: believe the stripes, which the "
                "interval "
                "holds\n",
                name);
        }
        // Stripes know nothing of a beta_U that is stated beside them.
        if (!f.fractiles && (whole(*f.mean) > f.seen.upper || whole(*f.mean) < f.seen.lower)) {
            text += fmt::format(
                "  note: {}: the curve's frequency lies outside what the stripes alone allow: believe "
                "the stripes\n",
                name);
        }
    }
    return text;
}

}  // namespace overturn
