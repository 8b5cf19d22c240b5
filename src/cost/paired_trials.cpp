#include "cost/detail/paired_trials.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <gsl/gsl_cdf.h>

#include "stats/probit.hpp"

namespace overturn::cost {

PairedTrials::PairedTrials(CampaignSpec const& spec, Plan const& plan, std::span<PreparedWave const> waves) {
    ModelSelector const selector(spec.effects, spec.accuracy);
    LimitJudge const judge(spec.limits, selector);
    for (auto const& level : spec.levels.levels) {
        levels_[level.value].assign(spec.bodies.size(), Stripe(waves.size()));
        if (level.purpose == LevelClass::design_basis) {
            design_basis_ = level.value;
        }
    }
    std::ranges::transform(waves, std::back_inserter(groups_), [&](PreparedWave const& wave) {
        return spec.source->about().shared(static_cast<std::int64_t>(wave.number));
    });
    std::size_t const together = waves_together(plan);
    auto const each = selector.extra_bytes();
    std::size_t const per_wave = plan.trials_per_wave();
    PhaseSeconds ignored;
    for (std::size_t first = 0; first < waves.size(); first += together) {
        TrialRows trials;
        append_trials(spec, plan, waves.subspan(first, std::min(together, waves.size() - first)), trials, ignored);
        for (std::size_t t = 0; t < trials.rows.size(); ++t) {
            auto const& row = trials.rows[t];
            auto const extra = std::span<std::byte const>(trials.extra).subspan(t * each, each);
            levels_.at(row.amplitude)[row.body][first + t / per_wave] = judge.judge(row, extra);
        }
    }
}

std::vector<FragilityPoint> PairedTrials::points(std::size_t body, std::size_t limit,
                                                 std::span<double const> weights) const {
    std::vector<FragilityPoint> points;
    for (auto const& [amplitude, bodies] : levels_) {
        FragilityPoint point;
        point.log_intensity = std::log(amplitude);
        auto const& stripe = bodies[body];
        for (std::size_t wave = 0; wave < stripe.size(); ++wave) {
            point.trials += stripe[wave].is_decided(limit) ? weights[wave] : 0;
            point.overturned += stripe[wave].has_passed(limit) ? weights[wave] : 0;
        }
        if (point.trials > 0) {
            points.push_back(point);
        }
    }
    return points;
}

bool PairedTrials::is_separated(std::size_t body, std::size_t limit, std::span<double const> weights) const {
    return state_of(points(body, limit, weights)) == FragilityState::separated;
}

std::optional<double> PairedTrials::log_median(std::size_t body, std::size_t limit,
                                               std::span<double const> weights) const {
    auto const points = this->points(body, limit, weights);
    auto const state = state_of(points);
    if (state == FragilityState::separated) {
        return separating_log_intensity(points);
    }
    auto const line = state == FragilityState::fitted ? fit_probit(points) : std::nullopt;
    return line && line->slope > 0 ? std::optional(line->log_median()) : std::nullopt;
}

Counts PairedTrials::counts(std::size_t body, std::size_t limit, std::optional<double> amplitude) const {
    Counts counts;
    for (auto const& [value, bodies] : levels_) {
        if (amplitude && value != *amplitude) {
            continue;
        }
        for (auto const& outcome : bodies[body]) {
            counts.decided += outcome.is_decided(limit) ? 1 : 0;
            counts.passed += outcome.has_passed(limit) ? 1 : 0;
        }
    }
    return counts;
}

namespace {

// Newly passed and no longer passed, of what both decide.
struct Flips {
    std::int64_t compared = 0, passed = 0, no_longer = 0;

    void add(std::span<LimitOutcomes const> before, std::span<LimitOutcomes const> after, std::size_t limit) {
        for (std::size_t wave = 0; wave < before.size(); ++wave) {
            if (before[wave].is_decided(limit) && after[wave].is_decided(limit)) {
                bool const was = before[wave].has_passed(limit);
                bool const is = after[wave].has_passed(limit);
                ++compared;
                passed += is && !was ? 1 : 0;
                no_longer += was && !is ? 1 : 0;
            }
        }
    }
};

// How many groups of waves that share what was drawn went rather one way, and the other.
std::pair<std::int64_t, std::int64_t> ways_of(std::span<LimitOutcomes const> before,
                                              std::span<LimitOutcomes const> after,
                                              std::span<std::int64_t const> groups, std::size_t limit) {
    std::map<std::int64_t, Flips> all;
    for (std::size_t wave = 0; wave < before.size(); ++wave) {
        all[groups[wave]].add(before.subspan(wave, 1), after.subspan(wave, 1), limit);
    }
    std::pair<std::int64_t, std::int64_t> ways;
    for (auto const& [group, flips] : all) {
        ways.first += flips.passed > flips.no_longer ? 1 : 0;
        ways.second += flips.passed < flips.no_longer ? 1 : 0;
    }
    return ways;
}

// Exact, two-sided: each of n that differ went either way with the same chance.
double p_value(std::int64_t one_way, std::int64_t other_way) {
    auto const n = static_cast<unsigned>(one_way + other_way);
    auto const fewer = static_cast<unsigned>(std::min(one_way, other_way));
    return n == 0 ? 1 : std::min(1.0, 2 * gsl_cdf_binomial_P(fewer, 0.5, n));
}

}  // namespace

Shift PairedTrials::shift_from(PairedTrials const& before, std::size_t body, std::size_t limit) const {
    Flips all;
    for (auto const& [amplitude, bodies] : levels_) {
        if (auto const there = before.levels_.find(amplitude); there != before.levels_.end()) {
            all.add(there->second[body], bodies[body], limit);
        }
    }
    Shift shift;
    shift.compared = all.compared;
    shift.passed = all.passed;
    shift.no_longer = all.no_longer;
    if (design_basis_ && before.design_basis_) {
        auto const& was = before.levels_.at(*before.design_basis_)[body];
        auto const& is = levels_.at(*design_basis_)[body];
        Flips there;
        there.add(was, is, limit);
        auto const [one_way, other_way] = ways_of(was, is, groups_, limit);
        shift.at_design_basis = counts(body, limit, design_basis_);
        shift.design_passed = there.passed;
        shift.design_no_longer = there.no_longer;
        shift.design_p_value = p_value(one_way, other_way);
    }
    return shift;
}

}  // namespace overturn::cost
