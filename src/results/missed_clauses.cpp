#include "results/missed_clauses.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "generators/acceptance.hpp"
#include "stats/quantile.hpp"

namespace overturn {
namespace {

constexpr std::array components{"horizontal", "transverse", "vertical", ""};
constexpr std::size_t whole_wave = 3;

/// What a row says of a clause on a spectrum, and where.
struct Figure {
    double value = 0;
    double period_s = 0;
    bool at_least = false;
};

std::optional<Figure> figure_of(std::string_view clause, ComponentMatch const& match, double worst_decade) {
    if (clause == "lowest ratio") {
        return Figure{match.lowest_ratio, match.lowest_period_s, true};
    }
    if (clause == "adjacent below") {
        return Figure{match.longest_below, match.longest_below_to_s, false};
    }
    if (clause == "highest ratio") {
        return Figure{match.highest_ratio, match.highest_period_s, false};
    }
    if (clause == "SI ratio") {
        return Figure{match.si_ratio, 0, true};
    }
    if (clause == "cov of the ratio") {
        return Figure{match.ratio_cov, 0, false};
    }
    if (clause == "error of the mean") {
        return Figure{std::abs(match.mean_ratio - 1), 0, false};
    }
    return clause == "worst decade" ? std::optional(Figure{worst_decade, 0, false}) : std::nullopt;
}

ComponentMatch horizontal_match(WaveRow const& row) {
    return {.lowest_ratio = row.match_lowest_ratio,
            .lowest_period_s = row.match_lowest_period_s,
            .highest_ratio = row.match_highest_ratio,
            .highest_period_s = row.match_highest_period_s,
            .longest_below = static_cast<double>(row.match_longest_below),
            .longest_below_to_s = row.match_longest_below_to_s,
            .si_ratio = row.si_ratio,
            .ratio_cov = row.match_ratio_cov,
            .mean_ratio = row.match_mean_ratio};
}

bool is_set(std::int64_t bits, std::size_t bit) { return (static_cast<std::uint64_t>(bits) >> bit & 1U) != 0; }

// Clauses that a component's spectrum is judged by; the others are about the wave.
constexpr std::size_t first_of_spectrum = 3;
constexpr std::size_t last_of_spectrum = 9;
constexpr std::int64_t of_spectrum = ((1 << (last_of_spectrum + 1)) - 1) & ~((1 << first_of_spectrum) - 1);

}  // namespace

void MissedClauses::add_component(std::size_t component, std::int64_t failures, ComponentMatch const& match,
                                  double worst_decade) {
    auto const names = clause_names();
    for (std::size_t clause = 0; clause < names.size(); ++clause) {
        if (!is_set(failures, clause)) {
            continue;
        }
        auto& seen = seen_[{clause, component}];
        ++seen.waves;
        auto const figure = component == whole_wave ? std::nullopt : figure_of(names[clause], match, worst_decade);
        if (!figure) {
            continue;
        }
        auto const worse = [&](double a, double b) { return figure->at_least ? std::min(a, b) : std::max(a, b); };
        seen.worst = seen.worst ? worse(*seen.worst, figure->value) : figure->value;
        if (figure->period_s > 0) {
            seen.periods_s.push_back(figure->period_s);
        }
    }
}

void MissedClauses::add(WaveRow const& row) {
    auto const by_component = row.horizontal_failures | row.transverse_failures | row.vertical_failures;
    add_component(0, row.horizontal_failures & of_spectrum, horizontal_match(row), row.match_worst_decade);
    add_component(1, row.transverse_failures & of_spectrum, row.transverse_match, row.transverse_match_worst_decade);
    add_component(2, row.vertical_failures & of_spectrum, row.vertical_match, row.vertical_match_worst_decade);
    add_component(whole_wave, row.acceptance_failures & ~(of_spectrum & by_component), {}, 0);
}

std::vector<MissedClause> MissedClauses::rows() const {
    auto const names = clause_names();
    std::vector<MissedClause> rows;
    for (auto const& [place, seen] : seen_) {
        MissedClause row{components.at(place.second), names[place.first], seen.waves, seen.worst};
        if (auto periods = seen.periods_s; !periods.empty()) {
            std::ranges::sort(periods);
            constexpr double tail = 0.05;
            row.from_period_s = quantile(periods, tail);
            row.to_period_s = quantile(periods, 1 - tail);
        }
        rows.push_back(std::move(row));
    }
    std::ranges::stable_sort(rows, std::greater<>(), &MissedClause::waves);
    return rows;
}

}  // namespace overturn
