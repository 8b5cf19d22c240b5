#include "stats/joint.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"

namespace overturn {
namespace {

// Counts of two bodies at one level: trials that decide both, those that overturned the first, the second, both.
struct Fourfold {
    double trials = 0, first = 0, second = 0, both = 0;

    [[nodiscard]] double covariance() const { return trials > 0 ? both - first * second / trials : 0; }
    [[nodiscard]] double first_variance() const { return trials > 0 ? first - first * first / trials : 0; }
    [[nodiscard]] double second_variance() const { return trials > 0 ? second - second * second / trials : 0; }
};

std::optional<double> correlation(double covariance, double first_variance, double second_variance) {
    double const variances = first_variance * second_variance;
    return variances > 0 ? std::optional(covariance / std::sqrt(variances)) : std::nullopt;
}

using Levels = std::map<double, std::vector<JointTrial const*>>;

Fourfold counted(std::vector<JointTrial const*> const& trials, std::size_t a, std::size_t b) {
    Fourfold counts;
    for (auto const* trial : trials) {
        if (trial->ends[a] == JointEnd::undecided || trial->ends[b] == JointEnd::undecided) {
            continue;
        }
        bool const first = trial->ends[a] == JointEnd::overturned;
        bool const second = trial->ends[b] == JointEnd::overturned;
        auto const many = static_cast<double>(trial->count);
        counts.trials += many;
        counts.first += first ? many : 0;
        counts.second += second ? many : 0;
        counts.both += first && second ? many : 0;
    }
    return counts;
}

JointPair pair_of(Levels const& levels, std::size_t a, std::size_t b) {
    JointPair pair{a, b, {}, {}};
    double covariance = 0;
    double first = 0;
    double second = 0;
    for (auto const& [amplitude, trials] : levels) {
        auto const counts = counted(trials, a, b);
        pair.phi.push_back(correlation(counts.covariance(), counts.first_variance(), counts.second_variance()));
        covariance += counts.covariance();
        first += counts.first_variance();
        second += counts.second_variance();
    }
    pair.pooled = correlation(covariance, first, second);
    return pair;
}

Stripe any_of(double amplitude, std::vector<JointTrial const*> const& trials, double group_size) {
    Stripe stripe{.amplitude = amplitude, .group_size = group_size};
    for (auto const* trial : trials) {
        bool const fell = std::ranges::count(trial->ends, JointEnd::overturned) > 0;
        bool const open = std::ranges::count(trial->ends, JointEnd::undecided) > 0;
        stripe.trials += trial->count;
        stripe.overturned += fell ? trial->count : 0;
        stripe.undecided += !fell && open ? trial->count : 0;
    }
    return stripe;
}

double independent(std::vector<JointTrial const*> const& trials) {
    double none = 1;
    for (std::size_t b = 0; b < trials.front()->ends.size(); ++b) {
        double decided = 0;
        double fell = 0;
        for (auto const* trial : trials) {
            auto const many = static_cast<double>(trial->count);
            decided += trial->ends[b] == JointEnd::undecided ? 0 : many;
            fell += trial->ends[b] == JointEnd::overturned ? many : 0;
        }
        none *= 1 - fell / decided;  // NaN where none is decided
    }
    return 1 - none;
}

}  // namespace

JointBodies study_joint(std::span<JointTrial const> trials, double group_size) {
    JointBodies joint;
    Levels levels;
    for (auto const& trial : trials) {
        OVERTURN_EXPECT(trial.ends.size() == trials.front().ends.size());
        levels[trial.amplitude].push_back(&trial);
    }
    for (auto const& [amplitude, here] : levels) {
        joint.any.push_back(any_of(amplitude, here, group_size));
        joint.if_independent.push_back(independent(here));
    }
    auto const bodies = trials.empty() ? 0 : trials.front().ends.size();
    for (std::size_t a = 0; a < bodies; ++a) {
        for (std::size_t b = a + 1; b < bodies; ++b) {
            joint.pairs.push_back(pair_of(levels, a, b));
        }
    }
    return joint;
}

}  // namespace overturn
