#include "stats/goodness_of_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gsl/gsl_cdf.h>

namespace overturn {
namespace {

struct Group {
    double trials = 0, overturned = 0, expected = 0;  // a group of trials counts as one

    void add(Group const& other) {
        trials += other.trials;
        overturned += other.overturned;
        expected += other.expected;
    }
    [[nodiscard]] bool fills() const {
        constexpr double least = 1;
        return expected >= least && trials - expected >= least;
    }
};

double deviance_of(Group const& group) {
    auto const term = [](double seen, double expected) { return seen > 0 ? 2 * seen * std::log(seen / expected) : 0; };
    return term(group.overturned, group.expected)
           + term(group.trials - group.overturned, group.trials - group.expected);
}

std::vector<Group> filled(std::vector<Group> const& groups) {
    std::vector<Group> pooled;
    Group open;
    for (auto const& group : groups) {
        open.add(group);
        if (open.fills()) {
            pooled.push_back(open);
            open = {};
        }
    }
    if (open.trials > 0 && !pooled.empty()) {
        pooled.back().add(open);
    }
    return pooled;
}

// Twice the smaller tail of the counts under the curve's P; a part of a group counts towards what was expected.
double tail_of(Group const& group) {
    double const p = group.expected / group.trials;
    auto const n = static_cast<unsigned>(std::ceil(group.trials));
    auto const k = static_cast<unsigned>(group.overturned);
    double const below = gsl_cdf_binomial_P(static_cast<unsigned>(std::ceil(group.overturned)), p, n);
    double const above = k == 0 ? 1 : gsl_cdf_binomial_Q(k - 1, p, n);
    return std::min(1.0, 2 * std::min(below, above));
}

std::vector<Group> groups_of(std::span<FragilityPoint const> points, ProbitLine const& line) {
    constexpr std::size_t groups_of_singles = 10;
    bool const singles = points.size() > stripes_at_most;
    double const share = sum_of(points).trials / static_cast<double>(groups_of_singles);
    std::vector<Group> groups;
    double before = 0;
    for (auto const& point : points) {
        Group const own{point.groups(), point.overturned / point.group_size,
                        point.groups() * gsl_cdf_ugaussian_P(line.at(point.log_intensity))};
        if (!singles || groups.empty() || before >= share * static_cast<double>(groups.size())) {
            groups.push_back(own);
        } else {
            groups.back().add(own);
        }
        before += point.trials;
    }
    return groups;
}

GoodnessOfFit judged(std::span<Group const> groups) {
    constexpr std::size_t few = 20;
    constexpr double many = 5;
    auto const pooled = filled({groups.begin(), groups.end()});
    GoodnessOfFit fit;
    fit.chi_squared = pooled.size() <= few;
    for (auto const& group : pooled) {
        fit.deviance += deviance_of(group);
        fit.chi_squared = fit.chi_squared && group.expected >= many && group.trials - group.expected >= many;
    }
    fit.degrees_of_freedom = std::max(static_cast<int>(pooled.size()) - 2, 0);
    if (fit.degrees_of_freedom > 0 && fit.chi_squared) {
        fit.p_value = gsl_cdf_chisq_Q(fit.deviance, fit.degrees_of_freedom);
    }
    return fit;
}

}  // namespace

GoodnessOfFit deviance_from(std::span<FragilityPoint const> points, ProbitLine const& line) {
    return judged(groups_of(points, line));
}

GoodnessOfFit goodness_of_fit(std::span<FragilityPoint const> points, ProbitLine const& line) {
    auto const groups = groups_of(points, line);
    auto fit = judged(groups);
    for (auto const& group : groups) {
        fit.stripe_p_value = std::min(fit.stripe_p_value, tail_of(group) * static_cast<double>(groups.size()));
    }
    return fit;
}

}  // namespace overturn
