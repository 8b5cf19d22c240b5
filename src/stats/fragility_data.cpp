#include "stats/fragility_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <unordered_set>

#include "core/error.hpp"
#include "stats/detail/extended_real.hpp"
#include "stats/detail/rising_order.hpp"

namespace overturn {
namespace {

void add(FragilityPoint& to, FragilityPoint const& what) {
    double const trials = to.trials + what.trials;
    to.log_intensity += trials > 0 ? (what.log_intensity - to.log_intensity) * what.trials / trials : 0;
    to.trials = trials;
    to.overturned += what.overturned;
    to.undecided += what.undecided;
    to.group_size = std::max(to.group_size, what.group_size);
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

// The values, rising, where they are no more than `most`.
std::optional<std::vector<double>> distinct_values(std::span<double const> values, std::size_t most) {
    std::unordered_set<double> found;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i == 0 || values[i] != values[i - 1]) {
            found.insert(values[i]);
        }
        if (found.size() > most) {
            return std::nullopt;
        }
    }
    std::vector<double> rising(found.begin(), found.end());
    std::ranges::sort(rising);
    return rising;
}

// A cell for each value.
Cells cells_of_values(std::span<SingleTrial const> trials, std::span<double const> logs,
                      std::span<double const> values) {
    Cells cells;
    cells.cell_of_trial.reserve(trials.size());
    for (double const value : values) {
        cells.points.push_back({value, 0, 0, 0});
    }
    for (std::size_t i = 0; i < trials.size(); ++i) {
        bool const again = i > 0 && logs[i] == logs[i - 1];
        auto const cell = again ? cells.cell_of_trial.back()
                                : static_cast<std::size_t>(std::ranges::lower_bound(values, logs[i]) - values.begin());
        cells.cell_of_trial.push_back(cell);
        cells.points[cell].trials += 1;
        cells.points[cell].overturned += trials[i].overturned ? 1 : 0;
    }
    return cells;
}

// Cells of equal width, those without a trial left out. Means are of the trials in rising order, to the last bit.
Cells cells_of_width(std::span<SingleTrial const> trials, std::vector<double> const& logs, std::size_t most) {
    auto const [least, greatest] = std::ranges::minmax(logs);
    double const low = least;
    double const width = (greatest - low) / static_cast<double>(most);
    auto const cell_of = [&](double log) {
        return static_cast<std::size_t>(std::min(std::floor((log - low) / width), static_cast<double>(most - 1)));
    };
    Cells cells;
    cells.cell_of_trial.reserve(trials.size());
    std::vector<double> overturned(most);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        cells.cell_of_trial.push_back(cell_of(logs[i]));
        overturned[cells.cell_of_trial.back()] += trials[i].overturned ? 1 : 0;
    }
    auto rising = logs;
    sort_rising(rising, std::identity());
    std::vector<std::size_t> place(most);
    std::size_t last = most;
    for (double const log : rising) {
        if (auto const cell = cell_of(log); cell != last) {
            last = cell;
            place[cell] = cells.points.size();
            cells.points.emplace_back();
        }
        add(cells.points.back(), {log, 1, 0, 0});
    }
    for (std::size_t cell = 0; cell < most; ++cell) {
        if (overturned[cell] > 0) {
            cells.points[place[cell]].overturned = overturned[cell];
        }
    }
    for (auto& cell : cells.cell_of_trial) {
        cell = place[cell];
    }
    return cells;
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
                              static_cast<double>(stripe.trials - stripe.decided()), stripe.group_size});
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
    auto const distinct = distinct_values(logs, most);
    return distinct ? cells_of_values(trials, logs, *distinct) : cells_of_width(trials, logs, most);
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
