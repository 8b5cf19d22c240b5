#include "stats/fragility_data.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "stats/detail/extended_real.hpp"

namespace overturn {
namespace {

void add(FragilityPoint& to, FragilityPoint const& what) {
    double const trials = to.trials + what.trials;
    to.log_intensity += trials > 0 ? (what.log_intensity - to.log_intensity) * what.trials / trials : 0;
    to.trials = trials;
    to.overturned += what.overturned;
    to.undecided += what.undecided;
    to.alike = std::max(to.alike, what.alike);
}

// The ends of what stood and of what overturned.
struct Ends {
    double highest_stood = -infinite, lowest_stood = infinite;
    double lowest_overturned = infinite, highest_overturned = -infinite;
};

Ends ends_of(std::span<FragilityPoint const> points) {
    Ends ends;
    for (auto const& point : points) {
        if (point.overturned < point.trials) {
            ends.highest_stood = std::max(ends.highest_stood, point.log_intensity);
            ends.lowest_stood = std::min(ends.lowest_stood, point.log_intensity);
        }
        if (point.overturned > 0) {
            ends.lowest_overturned = std::min(ends.lowest_overturned, point.log_intensity);
            ends.highest_overturned = std::max(ends.highest_overturned, point.log_intensity);
        }
    }
    return ends;
}

}  // namespace

std::vector<FragilityPoint> points_of(std::span<Stripe const> stripes) {
    std::vector<FragilityPoint> points;
    points.reserve(stripes.size());
    for (auto const& stripe : stripes) {
        OVERTURN_EXPECT(stripe.amplitude > 0);
        if (stripe.decided() > 0) {
            points.push_back({std::log(stripe.amplitude), static_cast<double>(stripe.decided()),
                              static_cast<double>(stripe.overturned),
                              static_cast<double>(stripe.trials - stripe.decided()),
                              static_cast<double>(stripe.alike)});
        }
    }
    std::sort(points.begin(), points.end(),
              [](auto const& a, auto const& b) { return a.log_intensity < b.log_intensity; });
    return points;
}

Cells cells_of(std::span<SingleTrial const> trials, std::size_t most) {
    std::vector<double> logs;
    logs.reserve(trials.size());
    for (auto const& trial : trials) {
        OVERTURN_EXPECT(trial.intensity > 0);
        logs.push_back(std::log(trial.intensity));
    }
    std::vector<std::size_t> order(trials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return logs[a] < logs[b]; });
    std::size_t distinct = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        distinct += i == 0 || logs[order[i]] > logs[order[i - 1]] ? 1 : 0;
    }
    double const low = order.empty() ? 0 : logs[order.front()];
    double const width = order.empty() ? 0 : (logs[order.back()] - low) / static_cast<double>(most);
    auto const cell = [&](std::size_t i) {
        return distinct <= most ? logs[i]
                                : std::min(std::floor((logs[i] - low) / width), static_cast<double>(most - 1));
    };
    Cells cells;
    cells.cell_of_trial.resize(trials.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || cell(order[i]) > cell(order[i - 1])) {
            cells.points.emplace_back();
        }
        add(cells.points.back(), {logs[order[i]], 1, trials[order[i]].overturned ? 1.0 : 0.0, 0});
        cells.cell_of_trial[order[i]] = cells.points.size() - 1;
    }
    return cells;
}

std::vector<FragilityPoint> points_of(std::span<SingleTrial const> trials, std::size_t most) {
    return cells_of(trials, most).points;
}

FragilityPoint sum_of(std::span<FragilityPoint const> points) {
    FragilityPoint sum;
    for (auto const& point : points) {
        add(sum, point);
    }
    return sum;
}

std::vector<FragilityPoint> grouped(std::span<FragilityPoint const> points, std::size_t most) {
    if (points.size() <= most) {
        return {points.begin(), points.end()};
    }
    double const share = sum_of(points).trials / static_cast<double>(most);
    std::vector<FragilityPoint> groups;
    double before = 0;
    for (auto const& point : points) {
        if (groups.empty() || before >= share * static_cast<double>(groups.size())) {
            groups.emplace_back();
        }
        add(groups.back(), point);
        before += point.trials;
    }
    return groups;
}

FragilityState state_of(std::span<FragilityPoint const> points) {
    auto const sum = sum_of(points);
    if (sum.trials == 0) {
        return FragilityState::no_trials;
    }
    if (sum.overturned == 0) {
        return FragilityState::none_overturned;
    }
    if (sum.overturned == sum.trials) {
        return FragilityState::all_overturned;
    }
    if (points.front().log_intensity == points.back().log_intensity) {
        return FragilityState::one_level;
    }
    auto const ends = ends_of(points);
    if (ends.highest_stood <= ends.lowest_overturned) {
        return FragilityState::separated;
    }
    return ends.highest_overturned <= ends.lowest_stood ? FragilityState::not_rising : FragilityState::fitted;
}

double separating_log_intensity(std::span<FragilityPoint const> points) {
    auto const ends = ends_of(points);
    return std::midpoint(ends.highest_stood, ends.lowest_overturned);
}

}  // namespace overturn
