#include "rare/detail/scout.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "rare/detail/answer_items.hpp"
#include "rare/detail/answer_row.hpp"
#include "rare/detail/normals.hpp"

namespace overturn::rare {
namespace {

std::vector<AnswerRow> look(Problem const& problem, double factor, DrawKey key, std::int64_t trials,
                            Workforce& workers) {
    return workers.map<AnswerRow>(
        {.name = fmt::format("scout-{}", key.level), .items = trials},
        [&](std::int64_t first, std::span<AnswerRow> out) {
            auto const draw = [&](std::size_t i, std::span<double> normals) {
                key.index = static_cast<std::uint64_t>(first) + i;
                draw_normals(key, normals);
            };
            answer_items(problem, out.size(), {&factor, 1}, draw,
                         [&](std::size_t i, std::span<Answer const> answers) { out[i] = row_of(answers.front()); });
        });
}

Count count_of(std::span<AnswerRow const> rows) {
    Count count{.trials = std::ssize(rows)};
    for (auto const& row : rows) {
        count.failed += row.failed;
        count.undecided += row.undecided;
    }
    return count;
}

// Of a nested driver the failures are the highest, but for few that came close.
double missed_by_driver(std::span<AnswerRow const> rows, std::int64_t failed) {
    std::size_t const within = 2 * failed;
    if (failed == 0 || within >= rows.size()) {
        return 0;
    }
    std::vector<double> drivers;
    for (auto const& row : rows) {
        drivers.push_back(row.driver);
    }
    std::nth_element(drivers.begin(), drivers.begin() + within, drivers.end(), std::greater<>());
    double const least = drivers[within];
    auto const missed = std::count_if(rows.begin(), rows.end(),
                                      [&](AnswerRow const& row) { return row.failed != 0 && row.driver < least; });
    return static_cast<double>(missed) / static_cast<double>(failed);
}

}  // namespace

Scouted scout(Problem const& problem, double factor, Request const& request, Workforce& workers) {
    constexpr double common = 0.05;
    constexpr double raise = 1.15;
    constexpr std::uint64_t attempts = 40;
    Scouted found{.factor = factor};
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
        if (found.runs + scout_trials > request.max_runs) {
            found.reason = fmt::format(
                "failure is not common at {:.3g} times the level, and more waves are not allowed "
                "(max_runs {})",
                found.factor / factor, request.max_runs);
            return found;
        }
        DrawKey const key{.seed = request.seed, .problem = request.problem, .phase = Phase::scout, .level = attempt};
        auto const rows = look(problem, found.factor, key, scout_trials, workers);
        found.runs += scout_trials;
        found.count = count_of(rows);
        found.at_first = attempt == 0 ? found.count : found.at_first;
        if (static_cast<double>(found.count.failed) >= common * static_cast<double>(scout_trials)) {
            found.missed = missed_by_driver(rows, found.count.failed);
            found.found = true;
            return found;
        }
        found.factor *= raise;
    }
    found.reason = fmt::format("not even {:.3g} times the level makes failure common", found.factor / factor);
    return found;
}

}  // namespace overturn::rare
