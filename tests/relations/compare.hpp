/// Rows held to what a relation makes of them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "relations/relation.hpp"

namespace overturn::testing {

/// How rows of a changed campaign meet those of the first.
struct Meeting {
    std::size_t trials = 0;
    std::size_t verdicts = 0;  ///< that agree
    std::size_t exact = 0;     ///< trials of which every bit is as it must be
    /// Of trials of one verdict, by column: differences over the larger of both, none of them 0.
    std::map<std::string, std::vector<double>> differences;
    std::vector<std::string> other_verdicts;  ///< trials, by their places

    void add(Meeting const& more) {
        trials += more.trials;
        verdicts += more.verdicts;
        exact += more.exact;
        for (auto const& [column, values] : more.differences) {
            auto& all = differences[column];
            all.insert(all.end(), values.begin(), values.end());
        }
        other_verdicts.insert(other_verdicts.end(), more.other_verdicts.begin(), more.other_verdicts.end());
    }
    [[nodiscard]] double largest() const {
        double largest = 0;
        for (auto const& [column, values] : differences) {
            largest = std::max(largest, *std::ranges::max_element(values));
        }
        return largest;
    }
    /// Of all trials, equal ones included. \param share 0.5: the median
    [[nodiscard]] double quantile(std::string const& column, double share) const {
        auto const found = differences.find(column);
        if (found == differences.end() || verdicts == 0) {
            return 0;
        }
        auto values = found->second;
        values.resize(std::max(values.size(), verdicts), 0.0);
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }
};

inline bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

inline double difference(double a, double b) {
    double const size = std::max(std::abs(a), std::abs(b));
    double const apart = std::abs(a - b) / size;
    return std::isnan(apart) ? 1 : apart;
}

// "m/s": length over time; "J/kg": its square.
inline double factor_of(Relation const& relation, std::string const& unit) {
    static std::map<std::string, std::array<int, 3>> const powers{
        {"1", {0, 0, 0}},     {"rad", {0, 0, 0}},    {"m", {1, 0, 0}},     {"s", {0, 1, 0}}, {"m/s", {1, -1, 0}},
        {"m/s2", {1, -2, 0}}, {"rad/s", {0, -1, 0}}, {"J/kg", {2, -2, 0}}, {"kg", {0, 0, 1}}};
    auto const& [length, time, mass] = powers.at(unit);
    return std::pow(relation.length, length) * std::pow(relation.time, time) * std::pow(relation.mass, mass);
}

inline bool speaks_of(Relation const& relation, std::string const& column) {
    auto const among = [&](std::vector<std::string> const& columns) {
        return std::ranges::find(columns, column) != columns.end();
    };
    return !among(relation.untold) && (relation.told.empty() || among(relation.told));
}

inline void compare_row(Relation const& relation, Rows const& first, std::size_t row, Rows const& changed,
                        std::size_t place, Meeting& meeting) {
    ++meeting.trials;
    bool const same_verdict = first.at(row, "verdict") == changed.at(place, "verdict");
    meeting.verdicts += same_verdict ? 1 : 0;
    bool exact = true;
    for (std::size_t c = 0; c < first.names.size(); ++c) {
        auto const& name = first.names[c];
        if (!speaks_of(relation, name)) {
            continue;
        }
        auto const image = relation.images.find(name);
        auto const column = image == relation.images.end() ? c : *changed.column(image->second.column);
        double const sign = image == relation.images.end() ? 1 : image->second.factor;
        double const expected = sign * factor_of(relation, first.units[c]) * first.rows[row][c];
        double const found = changed.rows[place][column];
        if (same_number(expected, found)) {
            continue;
        }
        exact = false;
        if (same_verdict) {
            meeting.differences[name].push_back(difference(expected, found));
        }
    }
    meeting.exact += exact ? 1 : 0;
    if (!same_verdict) {
        meeting.other_verdicts.push_back(
            fmt::format("row {}: {} for {}", row, changed.at(place, "verdict"), first.at(row, "verdict")));
    }
}

inline Meeting compare(Relation const& relation, Study const& study, Rows const& first) {
    auto changed_study = study;
    relation.change(changed_study);
    auto const changed = run(changed_study);
    auto const index = [](Study const& of, std::array<std::size_t, 3> at) {
        return (at[0] * of.solids.size() + at[1]) * of.factors.size() + at[2];
    };
    Meeting meeting;
    for (std::size_t motion = 0; motion < study.motions.size(); ++motion) {
        for (std::size_t solid = 0; solid < study.solids.size(); ++solid) {
            for (std::size_t level = 0; level < study.factors.size(); ++level) {
                std::array const at{motion, solid, level};
                auto const place = relation.place(study, at);
                if (place[2] != nowhere) {
                    compare_row(relation, first, index(study, at), changed, index(changed_study, place), meeting);
                }
            }
        }
    }
    return meeting;
}

}  // namespace overturn::testing
