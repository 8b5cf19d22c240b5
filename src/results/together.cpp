#include "results/together.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "results/detail/fitted_measures.hpp"

namespace overturn {
namespace {

std::vector<JointTrial> joint_trials(CampaignSpec const& spec, MeasuredTrials const& measured, std::size_t limit) {
    std::map<std::pair<std::int64_t, double>, JointTrial> by_wave;
    measured.each_outcome(limit, [&](TrialOutcome const& outcome) {
        auto& trial =
            by_wave
                .try_emplace({outcome.wave, outcome.amplitude},
                             JointTrial{outcome.amplitude, std::vector(spec.bodies.size(), JointEnd::undecided)})
                .first->second;
        trial.ends.at(static_cast<std::size_t>(outcome.body)) = !outcome.decided ? JointEnd::undecided
                                                                : outcome.passed ? JointEnd::overturned
                                                                                 : JointEnd::stood;
    });
    std::vector<JointTrial> trials;
    trials.reserve(by_wave.size());
    for (auto& [key, trial] : by_wave) {
        trials.push_back(std::move(trial));
    }
    return trials;
}

std::string phi_text(std::optional<double> const& phi) { return phi ? fmt::format("{:+.2f}", *phi) : "-"; }

std::string interval_text(Interval const& interval) {
    return fmt::format("[{:.3g}, {:.3g}]", interval.lower, interval.upper);
}

std::string estimate_text(Estimate const& estimate) {
    return fmt::format("{:.3g} {}", estimate.value, interval_text(estimate.interval));
}

}  // namespace

std::vector<BodiesTogether> bodies_together(CampaignSpec const& spec, Statistics const& statistics) {
    std::vector<BodiesTogether> together;
    if (spec.bodies.size() < 2 || spec.is_grid()) {
        return together;
    }
    for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
        together.push_back({spec.limits[limit].name, spec.limits[limit].passing(),
                            study_joint(joint_trials(spec, statistics.measured(), limit),
                                        static_cast<std::int64_t>(spec.source->waves_alike()))});
    }
    return together;
}

std::string together_table(CampaignSpec const& spec, std::vector<BodiesTogether> const& together, double confidence) {
    constexpr std::size_t most_pairs = 6;  // columns that a terminal holds
    std::string text;
    for (auto const& of : together) {
        auto const shown = std::min(of.joint.pairs.size(), most_pairs);
        std::vector<std::string> heads;
        for (std::size_t p = 0; p < shown; ++p) {
            auto const& pair = of.joint.pairs[p];
            heads.push_back(fmt::format("{}/{}", spec.bodies[pair.first].name, spec.bodies[pair.second].name));
        }
        auto const did = of.passing == Passing::exceeded ? "exceeds " + of.limit : std::string("overturns");
        auto const left = shown < of.joint.pairs.size()
                              ? fmt::format(" (the first {} of {} pairs; all in --json)", shown, of.joint.pairs.size())
                              : std::string();
        text += fmt::format("\nany of {} bodies {} under one wave; phi: correlation of two bodies' ends under it{}\n",
                            spec.bodies.size(), did, left);
        text += fmt::format("{:>12} {:>7} {:>7} {:>9} {:>8} {:>20} {:>14}  {}\n",
                            fmt::format("{} {}", spec.levels.measure_name(), spec.levels.shown_units()), "waves", "any",
                            "undecided", "P", fmt::format("{:g} % interval", 100 * confidence), "if independent",
                            fmt::join(heads, "  "));
        for (std::size_t l = 0; l < of.joint.any.size(); ++l) {
            auto const& any = of.joint.any[l];
            std::vector<std::string> phis;
            for (std::size_t p = 0; p < shown; ++p) {
                phis.push_back(fmt::format("{:>{}}", phi_text(of.joint.pairs[p].phi[l]), heads[p].size()));
            }
            text += fmt::format("{:>12.4g} {:>7} {:>7} {:>9} {:>8.4f} {:>20} {:>14.4f}  {}\n",
                                spec.levels.shown(any.amplitude), any.trials, any.overturned, any.undecided,
                                any.probability(), interval_text(any.interval(confidence)), of.joint.if_independent[l],
                                fmt::join(phis, "  "));
        }
        std::vector<std::string> pooled;
        for (std::size_t p = 0; p < shown; ++p) {
            pooled.push_back(fmt::format("{} {}", heads[p], phi_text(of.joint.pairs[p].pooled)));
        }
        text += fmt::format("  phi pooled over levels: {}\n", fmt::join(pooled, ", "));
    }
    return text;
}

MeasurePair parse_measures(std::string const& text, CampaignSpec const& spec) {
    auto const known = measures_of(spec);
    std::vector<std::string> names;
    std::vector<std::string> labels;  // "sa(1.9 s)", as tables write them
    std::ranges::transform(known, std::back_inserter(names), [&](auto measure) { return name_of(measure, spec); });
    std::ranges::transform(known, std::back_inserter(labels), [&](auto measure) { return label_of(measure, spec); });
    auto const comma = text.find(',');
    validate(comma != std::string::npos,
             "--measures: '{}' is not two measures (a comma parts them). State for example {},{}", text, names[0],
             names[1]);
    MeasurePair pair{};
    std::array const stated{text.substr(0, comma), text.substr(comma + 1)};
    for (std::size_t i = 0; i < pair.size(); ++i) {
        auto at = std::ranges::find(names, stated.at(i));
        if (at == names.end()) {
            at = names.begin() + (std::ranges::find(labels, stated.at(i)) - labels.begin());
        }
        validate(at != names.end(),
                 "--measures: '{}' is no measure of this campaign (its curves are over others). State two of {}",
                 stated.at(i), fmt::join(names, ", "));
        pair.at(i) = known[static_cast<std::size_t>(at - names.begin())];
    }
    validate(pair[0] != pair[1], "--measures: '{}' twice (one curve holds it). State two different ones", stated[0]);
    return pair;
}

std::vector<TwoMeasures> over_two_measures(CampaignSpec const& spec, Statistics const& statistics,
                                           MeasurePair const& measures, double confidence) {
    validate(!spec.is_grid(),
             "--measures for waves on a grid of frequencies (no random sample: no curve). Leave it out");
    constexpr int replicates = 1000;
    std::vector<TwoMeasures> fits;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
            auto const trials = statistics.measured().pairs(static_cast<std::int64_t>(b), measures, limit);
            fits.push_back({spec.bodies[b].name,
                            spec.limits[limit].name,
                            {name_of(measures[0], spec), name_of(measures[1], spec)},
                            fit_two_measures(trials, confidence, {spec.seed, b, replicates})});
        }
    }
    return fits;
}

std::string two_measures_text(std::vector<TwoMeasures> const& fits, double confidence) {
    std::string text =
        fmt::format("\nP over two measures (SI), {:g} % intervals by resampling waves\n", 100 * confidence);
    for (auto const& of : fits) {
        auto const who = of.limit == overturning_limit ? of.body : fmt::format("{}, {}", of.body, of.limit);
        if (!of.fit) {
            text += fmt::format(
                "  {}: no curve over {} and {} (all ended alike, are separated, or one measure is the "
                "other's multiple)\n",
                who, of.names[0], of.names[1]);
            continue;
        }
        auto const& fit = *of.fit;
        text += fmt::format(
            "  {}: P = Phi({:.4g} {:+.4g} ln {} {:+.4g} ln {}); ln {} {}, ln {} {}, beta where both scale {}; deviance "
            "{:.4g} below that of {} alone, the better one\n",
            who, fit.constant.value, fit.slopes[0].value, of.names[0], fit.slopes[1].value, of.names[1], of.names[0],
            estimate_text(fit.slopes[0]), of.names[1], estimate_text(fit.slopes[1]), estimate_text(fit.beta),
            fit.deviance_gain, of.names.at(fit.better));
    }
    return text;
}

}  // namespace overturn
