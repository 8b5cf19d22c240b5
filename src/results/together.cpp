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
#include "results/few_waves.hpp"

namespace overturn {
namespace {

// How often bodies ended so together, level by level: of any number of waves no more than levels times patterns.
class JointCounts {
  public:
    explicit JointCounts(std::size_t bodies) : none_(bodies, JointEnd::undecided) {}

    /// Waves come one after the other.
    void add(TrialOutcome const& outcome) {
        if (outcome.wave != wave_) {
            close_wave();
            wave_ = outcome.wave;
        }
        auto& ends = of_wave_.try_emplace(outcome.amplitude, none_).first->second;
        ends.at(outcome.body) = !outcome.decided ? JointEnd::undecided
                                : outcome.passed ? JointEnd::overturned
                                                 : JointEnd::stood;
    }
    [[nodiscard]] std::vector<JointTrial> take() {
        close_wave();
        std::vector<JointTrial> trials;
        for (auto const& [end, count] : counts_) {
            trials.push_back({end.first, end.second, count});
        }
        return trials;
    }

  private:
    void close_wave() {
        for (auto& end : of_wave_) {
            ++counts_[end];
        }
        of_wave_.clear();
    }

    std::vector<JointEnd> none_;
    std::int64_t wave_ = -1;
    std::map<double, std::vector<JointEnd>> of_wave_;
    std::map<std::pair<double, std::vector<JointEnd>>, std::int64_t> counts_;
};

std::vector<JointTrial> joint_trials(CampaignSpec const& spec, MeasuredTrials const& measured, std::size_t limit) {
    JointCounts counts(spec.bodies.size());
    measured.each_outcome(limit, [&](TrialOutcome const& outcome) { counts.add(outcome); });
    return counts.take();
}

}  // namespace

std::vector<BodiesTogether> bodies_together(CampaignSpec const& spec, Statistics const& statistics) {
    std::vector<BodiesTogether> together;
    if (spec.bodies.size() < 2 || no_sample(spec, statistics.waves().waves)) {
        return together;
    }
    for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
        together.push_back(
            {spec.limits[limit].name, spec.limits[limit].passing(),
             study_joint(joint_trials(spec, statistics.measured(), limit), spec.source->about().shared.effect())});
    }
    return together;
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
        pair.at(i) = known[at - names.begin()];
    }
    validate(pair[0] != pair[1], "--measures: '{}' twice (one curve holds it). State two different ones", stated[0]);
    return pair;
}

std::vector<TwoMeasures> over_two_measures(CampaignSpec const& spec, Statistics const& statistics,
                                           MeasurePair const& measures, double confidence) {
    validate(!spec.is_grid(),
             "--measures for waves on a grid of frequencies (no random sample: no curve). Leave it out");
    validate(!no_sample(spec, statistics.waves().waves),
             "--measures for {} recorded motions (a curve needs {} or more). Leave it out",
             spec.source->about().shared.among(statistics.waves().waves), least_records);
    constexpr int replicates = 1000;
    std::vector<TwoMeasures> fits;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        for (std::size_t limit = 0; limit < spec.limits.size(); ++limit) {
            auto const trials = statistics.measured().pairs(b, measures, limit);
            fits.push_back({spec.bodies[b].name,
                            spec.limits[limit].name,
                            {name_of(measures[0], spec), name_of(measures[1], spec)},
                            fit_two_measures(trials, confidence, {spec.seed, b, replicates})});
        }
    }
    return fits;
}

}  // namespace overturn
