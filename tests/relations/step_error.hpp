/// What the step does to every quantity of limit states: one campaign with steps that are halved again and again.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "campaign/limit_state.hpp"
#include "relations/compare.hpp"
#include "relations/family.hpp"

namespace overturn::testing {

/// Of trials that end the same way at two steps, one twice the other.
struct Halving {
    std::size_t trials = 0, flips = 0;
    std::map<std::string, std::vector<double>> differences;  ///< by quantity, over the larger of both; equal ones are 0
    std::map<std::string, std::array<double, 2>> sums;       ///< by quantity, magnitudes at the whole step and the half

    [[nodiscard]] double quantile(std::string const& quantity, double share) const {
        auto const found = differences.find(quantity);
        if (found == differences.end()) {
            return 0;
        }
        auto values = found->second;
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }
    void add(Halving const& more) {
        trials += more.trials;
        flips += more.flips;
        for (auto const& [quantity, values] : more.differences) {
            auto& all = differences[quantity];
            all.insert(all.end(), values.begin(), values.end());
        }
        for (auto const& [quantity, values] : more.sums) {
            sums[quantity][0] += values[0];
            sums[quantity][1] += values[1];
        }
    }
    /// By how much the mean over all trials moves, relative.
    [[nodiscard]] double drift(std::string const& quantity) const {
        auto const& [whole, half] = sums.at(quantity);
        return whole == half ? 0 : std::abs(whole - half) / std::max(whole, half);
    }
};

/// The study with steps so many times finer.
inline Rows run_finer(Study const& study, Family const& family, int times) {
    auto text = study.text();
    std::string const accuracy = "[accuracy]\n";
    std::string const step = fmt::format("contact_step={}\n", study.contact_step);
    if (family.points) {
        text.replace(text.find(step), step.size(), fmt::format("contact_step={}\n", study.contact_step / times));
    } else {
        text.insert(text.find(accuracy) + accuracy.size(), fmt::format("substeps={}\n", times));
    }
    return run_text(text, study.files());
}

// "peak_yaw" is the column of its own model.
inline std::optional<std::size_t> column_of(Rows const& rows, Family const& family, LimitQuantity const& quantity) {
    auto const name = quantity.of_every_model
                          ? quantity.name
                          : fmt::format("{}.{}", family.space ? "spatial" : "contact", quantity.name);
    return rows.column(name);
}

inline void add_halving(Rows const& whole, Rows const& half, Family const& family, Halving& halving) {
    std::map<std::string, std::size_t> columns;
    for (auto const& quantity : limit_quantities()) {
        if (auto const column = column_of(whole, family, quantity)) {
            columns.emplace(quantity.name, *column);
        }
    }
    for (std::size_t i = 0; i < whole.rows.size(); ++i) {
        ++halving.trials;
        if (whole.at(i, "verdict") != half.at(i, "verdict")) {
            ++halving.flips;
            continue;
        }
        for (auto const& [name, column] : columns) {
            double const a = whole.rows[i][column];
            double const b = half.rows[i][column];
            if ((std::isnan(a) && std::isnan(b)) || (a == 0 && b == 0)) {
                continue;
            }
            halving.differences[name].push_back(same_number(a, b) ? 0 : difference(a, b));
            bool const bounded = std::isfinite(a) && std::isfinite(b);
            halving.sums[name][0] += bounded ? std::abs(a) : 0;
            halving.sums[name][1] += bounded ? std::abs(b) : 0;
        }
    }
}

/// From one step to its half, and from that to the next, so many times.
inline std::vector<Halving> halvings(Family const& family, std::uint64_t first_seed, std::uint64_t last_seed,
                                     std::size_t times) {
    std::vector<Halving> all(times);
    for (auto seed = first_seed; seed <= last_seed; ++seed) {
        auto const study = drawn_study(family, seed);
        auto whole = run_finer(study, family, 1);
        for (std::size_t k = 0; k < times; ++k) {
            auto half = run_finer(study, family, 2 << k);
            add_halving(whole, half, family, all[k]);
            whole = std::move(half);
        }
    }
    return all;
}

}  // namespace overturn::testing
